//! The zero problem of a periodic orbit: (2.3) with a phase condition, over any number of segments.

use nalgebra::{DMatrix, DVector};

use super::phase::Phase;
use crate::continuation::{Linearisation, ZeroProblem};
use crate::field::Work;
use crate::flow::{Family, Flow, FlowError, Passage, Place, Velocity, Want, wrapped};
use std::f64::consts::TAU;

/// Half an extent below this share of a state is rounding error.
const RESTS: f64 = 1e-8;

type Mode<F, const N: usize> = <<F as Family<N>>::Flow as Flow<N>>::Mode;

/// A start is left for a calmer one whose field turns this many times more slowly.
const HASTE: f64 = 4.0;
/// Share of the period by which a start keeps away from events.
const MARGIN: f64 = 0.01;
/// An orbit that has shrunk to this share of its largest extent ends in an equilibrium.
const VANISHED: f64 = 1e-4;

/// Unknowns are the starts x₁ … xₘ of `m` segments and the period T; the equations are
/// φ(xᵢ, T/m) − xᵢ₊₁ = 0, cyclically, and a phase condition on x₁.
#[derive(Debug, Clone)]
pub struct OrbitProblem<F: Family<N>, const N: usize> {
    /// The flows.
    pub family: F,
    /// The phase condition.
    pub phase: Phase<N>,
    /// Usual magnitudes of the states: half their extent along the orbit.
    pub magnitude: [f64; N],
    /// Usual magnitude of the period.
    pub period: f64,
    /// What the passages shall report besides derivatives.
    pub want: Want,
    /// Work of all evaluations.
    pub work: Work,
    modes: Vec<Mode<F, N>>,
    largest: [f64; N],
    /// States of the last accepted orbit at which it could begin as well.
    others: Vec<[f64; N]>,
}

/// One evaluation of the problem: the motion once around.
#[derive(Debug, Clone)]
pub struct Shot<const N: usize, Mode> {
    /// One passage for each segment.
    pub passages: Vec<Passage<N, Mode>>,
    /// Where the first begins.
    pub start: Place<N, Mode>,
    /// The field there.
    pub velocity: Velocity<N>,
    /// The period tried.
    pub period: f64,
    /// The state that is the phase of a drive, if there is one.
    pub drive: Option<usize>,
}

impl<F: Family<N>, const N: usize> OrbitProblem<F, N> {
    /// The problem of an orbit near the one through `starts`, of about this period.
    pub fn new(
        family: F,
        phase: Phase<N>,
        starts: &[Place<N, Mode<F, N>>],
        period: f64,
        magnitude: [f64; N],
    ) -> Self {
        Self {
            family,
            phase,
            magnitude,
            period,
            want: Want {
                derivatives: true,
                extrema: true,
                ..Want::default()
            },
            work: Work::default(),
            modes: starts.iter().map(|place| place.mode).collect(),
            largest: magnitude,
            others: Vec::new(),
        }
    }

    /// The unknowns for these starts and this period.
    #[must_use]
    pub fn unknowns(starts: &[[f64; N]], period: f64) -> DVector<f64> {
        let states = starts.iter().flatten().copied();
        DVector::from_iterator(starts.len() * N + 1, states.chain(std::iter::once(period)))
    }

    /// Lets the start float along the orbit, orthogonally to the field, from `place` at r.
    ///
    /// # Errors
    /// The field is not finite there.
    pub fn float(&mut self, place: &Place<N, Mode<F, N>>, r: f64) -> Result<(), FlowError> {
        let velocity = self.family.at(r)?.velocity(place)?.f;
        self.phase = Phase::floating(F::Flow::PHASE, place.state, velocity);
        Ok(())
    }

    fn segment(&self, z: &DVector<f64>, i: usize) -> [f64; N] {
        std::array::from_fn(|j| z[i * N + j])
    }
}

impl<F: Family<N> + Clone, const N: usize> ZeroProblem for OrbitProblem<F, N> {
    type Error = FlowError;
    type Extra = Shot<N, Mode<F, N>>;

    fn evaluate(
        &mut self,
        z: &DVector<f64>,
        r: f64,
    ) -> Result<Linearisation<Self::Extra>, FlowError> {
        let (m, n) = (self.modes.len(), z.len());
        let period = z[n - 1];
        if !(period > 0.0 && period.is_finite()) {
            return Err(FlowError::BadTime { time: period });
        }
        let flow = self.family.at(r)?;
        let mut h = DVector::zeros(n);
        let mut h_z = DMatrix::zeros(n, n);
        let mut h_r = DVector::zeros(n);
        let mut passages = Vec::with_capacity(m);
        for i in 0..m {
            let from = Place {
                state: self.segment(z, i),
                mode: self.modes[i],
            };
            let passage = flow.advance(&from, period / m as f64, self.want)?;
            self.work += passage.work;
            // A start that is held on a surface hides a motion that does not come back to it.
            if passage.end.mode != self.modes[(i + 1) % m] {
                return Err(FlowError::OtherMode {
                    found: format!("{:?}", passage.end.mode),
                    wanted: format!("{:?}", self.modes[(i + 1) % m]),
                });
            }
            let next = self.segment(z, (i + 1) % m);
            if let Some(derivatives) = &passage.derivatives {
                for row in 0..N {
                    let (at, unit) = (i * N + row, self.magnitude[row]);
                    let mut gap = passage.end.state[row] - next[row];
                    if F::Flow::PHASE == Some(row) && i + 1 == m {
                        // Once around, the phase has turned a whole number of times, and at least once.
                        gap -= TAU * (gap / TAU).round().max(1.0);
                    }
                    h[at] = gap / unit;
                    h_r[at] = derivatives.design[row] / unit;
                    h_z[(at, n - 1)] = derivatives.time[row] / (m as f64 * unit);
                    for column in 0..N {
                        h_z[(at, i * N + column)] += derivatives.state[row][column] / unit;
                    }
                    h_z[(at, ((i + 1) % m) * N + row)] -= 1.0 / unit;
                }
            }
            passages.push(passage);
        }
        let start = Place {
            state: self.segment(z, 0),
            mode: self.modes[0],
        };
        let velocity = flow.velocity(&start)?;
        let (value, gradient, design) = self.phase.equation(&start.state, &velocity);
        let unit: f64 = (0..N)
            .map(|j| (gradient[j] * self.magnitude[j]).abs())
            .sum();
        let unit = if unit > 0.0 { unit } else { 1.0 };
        h[n - 1] = value / unit;
        h_r[n - 1] = design / unit;
        for (column, slope) in gradient.iter().enumerate() {
            h_z[(n - 1, column)] = slope / unit;
        }
        self.work.newton += 1;
        Ok(Linearisation {
            residual: h,
            jacobian: h_z,
            design: h_r,
            extra: Shot {
                passages,
                start,
                velocity,
                period,
                drive: F::Flow::PHASE,
            },
        })
    }

    fn scale(&self) -> DVector<f64> {
        let m = self.modes.len();
        DVector::from_fn(m * N + 1, |i, _| {
            if i == m * N {
                self.period
            } else {
                self.magnitude[i % N]
            }
        })
    }

    fn accept(
        &mut self,
        z: &DVector<f64>,
        r: f64,
        shot: &Self::Extra,
    ) -> Result<Option<DVector<f64>>, FlowError> {
        self.period = shot.period;
        self.magnitude = shot.magnitude(&self.magnitude);
        let largest = (0..N).fold(0.0_f64, |most, j| {
            most.max(self.magnitude[j] / self.largest[j])
        });
        for j in 0..N {
            self.largest[j] = self.largest[j].max(self.magnitude[j]);
        }
        if largest < VANISHED {
            return Err(FlowError::Vanished {
                state: shot.start.state.to_vec(),
            });
        }
        if matches!(self.phase, Phase::Section(_)) {
            return Ok(None);
        }
        self.others = shot.turns();
        let calmer = self.calmer(r, shot)?;
        let start = calmer.unwrap_or(Place {
            state: self.segment(z, 0),
            mode: self.modes[0],
        });
        let velocity = self.family.at(r)?.velocity(&start)?.f;
        self.phase = Phase::floating(F::Flow::PHASE, start.state, velocity);
        self.modes[0] = start.mode;
        Ok(calmer.map(|place| Self::unknowns(&[place.state], shot.period)))
    }

    fn elsewhere(&mut self, r: f64, trial: usize) -> Option<DVector<f64>> {
        let state = *self.others.get(trial)?;
        let flow = self.family.at(r).ok()?;
        let place = flow.place(state).ok()?;
        self.phase = Phase::Orthogonal {
            at: state,
            velocity: flow.velocity(&place).ok()?.f,
        };
        self.modes[0] = place.mode;
        Some(Self::unknowns(&[state], self.period))
    }

    /// What depends on where along the orbit it starts is left out: only the period and r stay.
    fn lasting(&self, tangent: &DVector<f64>) -> DVector<f64> {
        let mut lasting = tangent.clone();
        lasting.rows_mut(0, tangent.len() - 2).fill(0.0);
        lasting
    }
}

impl<F: Family<N>, const N: usize> OrbitProblem<F, N> {
    /// A place on the orbit where Newton has it much easier than at the present start, if there is one.
    ///
    /// Shooting from a fast stretch makes the end bend strongly with the period; from just before
    /// an event, the start would leave its mode as r changes.
    fn calmer(
        &self,
        r: f64,
        shot: &Shot<N, Mode<F, N>>,
    ) -> Result<Option<Place<N, Mode<F, N>>>, FlowError> {
        let [passage] = shot.passages.as_slice() else {
            return Ok(None);
        };
        let mut place = passage.calm.place;
        place.state = wrapped::<F::Flow, N>(place.state);
        let haste = |velocity: &Velocity<N>| {
            let bend = |i: usize| {
                (0..N)
                    .map(|j| velocity.jacobian[i][j] * velocity.f[j])
                    .sum::<f64>()
            };
            let scaled = |v: f64, j: usize| (v / self.magnitude[j]).powi(2);
            let (bends, speeds) = (0..N).fold((0.0, 0.0), |(bends, speeds), j| {
                (
                    bends + scaled(bend(j), j),
                    speeds + scaled(velocity.f[j], j),
                )
            });
            (bends / speeds).sqrt()
        };
        let there = self.family.at(r)?.velocity(&place)?;
        let near = |event: &crate::flow::Event<N>| {
            let share = event.time / shot.period;
            event.is_switch() && !(MARGIN..=1.0 - MARGIN).contains(&share)
        };
        let hasty = haste(&shot.velocity) > HASTE * haste(&there).max(1.0 / shot.period);
        Ok((hasty || passage.events.iter().any(near)).then_some(place))
    }
}

/// Most places at which an orbit is begun anew.
const OTHERS: usize = 4;

impl<const N: usize, Mode> Shot<N, Mode> {
    /// States in which the first state is least or greatest, spread over the motion; none where it is
    /// divided into segments.
    fn turns(&self) -> Vec<[f64; N]> {
        let [passage] = self.passages.as_slice() else {
            return Vec::new();
        };
        let turns = |maximum: bool| {
            let found = passage.extrema.iter();
            let found = found.filter(move |e| e.index == 0 && e.maximum == maximum);
            found.map(|e| e.state).take(OTHERS / 2)
        };
        turns(false).chain(turns(true)).collect()
    }

    /// Smallest and largest value of each state along the motion.
    ///
    /// The ends of steps count too: in a layer so stiff that a rate is all rounding error, no extremum shows.
    #[must_use]
    pub fn extent(&self) -> ([f64; N], [f64; N]) {
        let (mut low, mut high) = (self.start.state, self.start.state);
        for passage in &self.passages {
            for extremum in &passage.extrema {
                let (j, value) = (extremum.index, extremum.state[extremum.index]);
                low[j] = low[j].min(value);
                high[j] = high[j].max(value);
            }
            for j in 0..N {
                low[j] = low[j].min(passage.calm.low[j]);
                high[j] = high[j].max(passage.calm.high[j]);
            }
        }
        if let Some(phase) = self.drive {
            (low[phase], high[phase]) = (0.0, TAU);
        }
        (low, high)
    }

    /// Half the extent of each state; `fallback` where it has none.
    fn magnitude(&self, fallback: &[f64; N]) -> [f64; N] {
        let (low, high) = self.extent();
        half_extents(&low, &high, fallback)
    }
}

/// Half the extent of each state; `fallback` for one that rests, and so has none to be measured against.
pub(super) fn half_extents<const N: usize>(
    low: &[f64; N],
    high: &[f64; N],
    fallback: &[f64; N],
) -> [f64; N] {
    std::array::from_fn(|j| {
        let half = 0.5 * (high[j] - low[j]);
        if half > RESTS * low[j].abs().max(high[j].abs()) && half.is_finite() {
            half
        } else {
            fallback[j]
        }
    })
}

//! The zero problem of an orbit that grazes: a sliding contact comes to rest for a moment.
//!
//! Shooting starts at the graze itself. The motion is followed back to it and held in the mode in which
//! it slides there, so that the equations are smooth on both sides of the graze and no guard has to fall
//! tangentially: the contact's speed and its rate vanish at the start.

use nalgebra::{DMatrix, DVector};

use super::plane::Plane;
use crate::continuation::{Linearisation, ZeroProblem};
use crate::field::Work;
use crate::flow::exact::Glide;
use crate::flow::{Derivatives, EventKind, Flow, FlowError, Place, Steered, Want};
use crate::shooting::Orbit;

type Mode<F, const N: usize> = <<F as crate::flow::Family<N>>::Flow as Flow<N>>::Mode;

/// Step of the differences that give the slopes of a contact's speed and rate, relative to the scales.
const DIFFERENCE: f64 = 1e-6;
/// A stretch of this share of the period is none.
const BRIEF: f64 = 1e-3;

/// Unknowns are the state at the graze, the period and p; q is the design variable.
#[derive(Debug, Clone)]
pub struct GrazingProblem<F: Steered<N>, const N: usize> {
    plane: Plane<F>,
    graze: Graze<N, Mode<F, N>>,
    magnitude: [f64; N],
    /// Usual magnitudes of p and q.
    scales: [f64; 2],
    /// Usual magnitude of the period.
    period: f64,
    /// Work of all evaluations.
    pub work: Work,
}

/// Where an orbit grazes, or nearly does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Graze<const N: usize, Mode> {
    contact: usize,
    state: [f64; N],
    /// Modes before and after.
    modes: [Mode; 2],
    /// Shares of the period up to which the motion is held in its mode, and from which on.
    held: [f64; 2],
}

impl<const N: usize, Mode: Copy + PartialEq> Graze<N, Mode> {
    /// The place of an orbit that is nearest to a graze: a contact that lands most slowly, or slides by
    /// most closely; `None` if no contact slides.
    #[must_use]
    pub fn of(orbit: &Orbit<N, Mode>) -> Option<Self> {
        let margin = |kind: &EventKind, rate: f64| match kind {
            EventKind::Landing { .. } | EventKind::Crossing { .. } if rate < 0.0 => Some(-rate),
            EventKind::Nearest { margin } => Some(*margin),
            _ => None,
        };
        let near = orbit.events.iter().filter_map(|event| {
            let value = margin(&event.kind, event.rate)?;
            let stuck = matches!(event.kind, EventKind::Nearest { .. })
                && event.mode == crate::field::exact::Mode::Stick;
            (!stuck).then_some((value, event))
        });
        let (_, event) = near.min_by(|a, b| a.0.total_cmp(&b.0))?;
        let (before, after, stays) = around(orbit, event.time)?;
        let others = orbit.events.iter().filter(|other| {
            other.is_switch() && (other.time - event.time).abs() > BRIEF * orbit.period
        });
        let ahead = |time: f64| (time - event.time).rem_euclid(orbit.period) / orbit.period;
        let gaps: Vec<f64> = others.map(|other| ahead(other.time)).collect();
        let next = gaps.iter().copied().fold(1.0, f64::min);
        let last = gaps.iter().copied().fold(0.0, f64::max);
        Some(Self {
            contact: event.contact,
            state: event.state,
            modes: [before, if stays { after } else { before }],
            held: [if stays { 0.0 } else { 0.5 * next }, 0.5 + 0.5 * last],
        })
    }
}

/// The modes before and after a time of an orbit, and whether the later one lasts.
fn around<const N: usize, Mode: Copy + PartialEq>(
    orbit: &Orbit<N, Mode>,
    time: f64,
) -> Option<(Mode, Mode, bool)> {
    let near = BRIEF * 1e-3 * orbit.period;
    let mut end = 0.0;
    for (i, segment) in orbit.segments.iter().enumerate() {
        end += segment.duration;
        if (end - time).abs() <= near {
            let after = orbit.segments[(i + 1) % orbit.segments.len()];
            let stays = after.mode != segment.mode && after.duration > BRIEF * orbit.period;
            return Some((segment.mode, after.mode, stays));
        }
        if end > time {
            return Some((segment.mode, segment.mode, false));
        }
    }
    None
}

/// How a motion once around depends on its start, its duration and a design variable.
struct Round<const N: usize> {
    end: [f64; N],
    derivatives: Derivatives<N>,
}

impl<F: Steered<N>, const N: usize> GrazingProblem<F, N>
where
    F::Flow: Glide<N>,
{
    /// The problem near an orbit that nearly grazes.
    pub fn new(
        plane: Plane<F>,
        orbit: &Orbit<N, Mode<F, N>>,
        graze: Graze<N, Mode<F, N>>,
        scales: [f64; 2],
    ) -> Self {
        Self {
            plane,
            graze,
            magnitude: orbit.magnitude(),
            scales,
            period: orbit.period,
            work: Work::default(),
        }
    }

    /// The unknowns from which to converge.
    #[must_use]
    pub fn unknowns(&self, p: f64) -> DVector<f64> {
        let state = self.graze.state.iter().copied();
        DVector::from_iterator(N + 2, state.chain([self.period, p]))
    }

    /// Once around, in at most three pieces.
    fn round(
        &mut self,
        flow: &F::Flow,
        state: [f64; N],
        period: f64,
    ) -> Result<Round<N>, FlowError> {
        let [before, after] = self.graze.modes;
        let [first, last] = self.graze.held;
        let start = Place { state, mode: after };
        let (place, lead) = flow.glide(&start, first * period)?;
        let want = Want {
            derivatives: true,
            ..Want::default()
        };
        let passage = flow.advance(&place, (last - first) * period, want)?;
        self.work += passage.work;
        if passage.end.mode != before {
            return Err(FlowError::OtherMode {
                found: format!("{:?}", passage.end.mode),
                wanted: format!("{before:?}"),
            });
        }
        let middle = passage.derivatives.unwrap_or_else(|| lead.clone());
        let (end, rest) = flow.glide(&passage.end, (1.0 - last) * period)?;
        let all = chain(&chain(&lead, &middle), &rest);
        Ok(Round {
            end: end.state,
            derivatives: all,
        })
    }

    /// The speed of the contact at the graze, and its rate.
    fn touch(&self, state: [f64; N], p: f64, q: f64) -> Result<[f64; 2], FlowError> {
        let flow = self.plane.at(p, q)?;
        let at = Place {
            state,
            mode: self.graze.modes[0],
        };
        let touch = flow.touch(&at, self.graze.contact)?;
        touch.ok_or(FlowError::BadTime { time: 0.0 })
    }
}

/// The derivatives of one motion after another. The motion's own velocity is carried into itself, so that
/// with any share of the time the end moves at its velocity there.
fn chain<const N: usize>(first: &Derivatives<N>, second: &Derivatives<N>) -> Derivatives<N> {
    let times = |row: usize, column: &dyn Fn(usize) -> f64| -> f64 {
        (0..N).map(|k| second.state[row][k] * column(k)).sum()
    };
    Derivatives {
        state: std::array::from_fn(|i| std::array::from_fn(|j| times(i, &|k| first.state[k][j]))),
        design: std::array::from_fn(|i| second.design[i] + times(i, &|k| first.design[k])),
        time: second.time,
        trace: first.trace + second.trace,
        factors: Vec::new(),
        lost: first.lost.max(second.lost),
    }
}

/// An orbit at its graze.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GrazingShot<const N: usize> {
    /// The state at the graze.
    pub state: [f64; N],
    /// The period.
    pub period: f64,
    /// The rate of the contact's speed there, as it was met.
    pub rate: f64,
    /// Whether the speed is least there, and not largest.
    pub least: bool,
}

impl<F: Steered<N>, const N: usize> GrazingProblem<F, N>
where
    F::Flow: Glide<N>,
{
    /// Speed and rate, with their slopes along all unknowns but the period, and along q.
    fn touches(&self, z: &DVector<f64>, q: f64) -> Result<([f64; 2], DMatrix<f64>), FlowError> {
        let at = |z: &DVector<f64>, q: f64| {
            let state: [f64; N] = std::array::from_fn(|j| z[j]);
            self.touch(state, z[N + 1], q)
        };
        let scale = self.scale();
        let mut slopes = DMatrix::zeros(2, N + 3);
        for i in (0..N).chain([N + 1, N + 2]) {
            let mut ends = [(z.clone(), q), (z.clone(), q)];
            for ((z, q), sign) in ends.iter_mut().zip([-1.0, 1.0]) {
                if i == N + 2 {
                    *q += sign * DIFFERENCE * self.scales[1];
                } else {
                    z[i] += sign * DIFFERENCE * scale[i];
                }
            }
            let place = |(z, q): &(DVector<f64>, f64)| if i == N + 2 { *q } else { z[i] };
            let width = place(&ends[1]) - place(&ends[0]);
            let [low, high] = [at(&ends[0].0, ends[0].1)?, at(&ends[1].0, ends[1].1)?];
            for row in 0..2 {
                slopes[(row, i)] = (high[row] - low[row]) / width;
            }
        }
        Ok((at(z, q)?, slopes))
    }

    /// Whether the contact, slid on, is faster again.
    fn is_least(&self, state: [f64; N], period: f64, p: f64, q: f64) -> Result<bool, FlowError> {
        let flow = self.plane.at(p, q)?;
        let mode = self.graze.modes[0];
        let (later, _) = flow.glide(&Place { state, mode }, BRIEF * period)?;
        let touch = flow.touch(&later, self.graze.contact)?;
        Ok(touch.is_some_and(|[_, rate]| rate > 0.0))
    }
}

impl<F: Steered<N>, const N: usize> ZeroProblem for GrazingProblem<F, N>
where
    F::Flow: Glide<N>,
{
    type Error = FlowError;
    type Extra = GrazingShot<N>;

    fn evaluate(
        &mut self,
        z: &DVector<f64>,
        q: f64,
    ) -> Result<Linearisation<GrazingShot<N>>, FlowError> {
        let state: [f64; N] = std::array::from_fn(|j| z[j]);
        let (period, p) = (z[N], z[N + 1]);
        if !(period > 0.0 && period.is_finite()) {
            return Err(FlowError::BadTime { time: period });
        }
        let along_p = self.plane.along_p(q).at(p)?;
        let round = self.round(&along_p, state, period)?;
        let along_q = self.plane.along_q(p).at(q)?;
        let across = self.round(&along_q, state, period)?.derivatives.design;
        let (touch, slopes) = self.touches(z, q)?;
        let n = N + 2;
        let mut linearisation = Linearisation {
            residual: DVector::zeros(n),
            jacobian: DMatrix::zeros(n, n),
            design: DVector::zeros(n),
            extra: GrazingShot {
                state,
                period,
                rate: touch[1],
                least: self.is_least(state, period, p, q)?,
            },
        };
        let derivatives = &round.derivatives;
        for i in 0..N {
            let unit = self.magnitude[i];
            linearisation.residual[i] = (round.end[i] - state[i]) / unit;
            for j in 0..N {
                let own = f64::from(i == j);
                linearisation.jacobian[(i, j)] = (derivatives.state[i][j] - own) / unit;
            }
            linearisation.jacobian[(i, N)] = derivatives.time[i] / unit;
            linearisation.jacobian[(i, N + 1)] = derivatives.design[i] / unit;
            linearisation.design[i] = across[i] / unit;
        }
        for (row, value) in touch.into_iter().enumerate() {
            let weight = (0..N).map(|j| (slopes[(row, j)] * self.magnitude[j]).abs());
            let unit = weight.sum::<f64>().max(f64::MIN_POSITIVE);
            linearisation.residual[N + row] = value / unit;
            for j in 0..n {
                linearisation.jacobian[(N + row, j)] = slopes[(row, j)] / unit;
            }
            linearisation.design[N + row] = slopes[(row, N + 2)] / unit;
        }
        self.work.newton += 1;
        Ok(linearisation)
    }

    fn scale(&self) -> DVector<f64> {
        let states = self.magnitude.iter().copied();
        DVector::from_iterator(N + 2, states.chain([self.period, self.scales[0]]))
    }

    fn accept(
        &mut self,
        _z: &DVector<f64>,
        _q: f64,
        shot: &GrazingShot<N>,
    ) -> Result<Option<DVector<f64>>, FlowError> {
        self.period = shot.period;
        Ok(None)
    }
}

//! The zero problem of an orbit that grazes: a sliding contact comes to rest for a moment.
//!
//! Shooting starts at the graze itself. The motion is followed back to it and held in the mode in which
//! it slides there, so that the equations are smooth on both sides of the graze and no guard has to fall
//! tangentially: the contact's speed and its rate vanish at the start.

use nalgebra::{DMatrix, DVector};

use super::graze::{BRIEF, Graze};
use super::plane::Plane;
use crate::continuation::{Linearisation, ZeroProblem};
use crate::field::Work;
use crate::flow::{FlowError, Want};
use crate::motion::{Derivatives, Flow, Place, spelt};
use crate::shooting::Orbit;

/// Step of the differences that give the slopes of a contact's speed and rate, relative to the scales.
const DIFFERENCE: f64 = 1e-6;

/// Unknowns are the state at the graze, the period and p; q is the design variable.
#[derive(Debug, Clone)]
pub struct GrazingProblem {
    plane: Plane,
    graze: Graze,
    magnitude: Vec<f64>,
    /// Usual magnitudes of p and q.
    scales: [f64; 2],
    /// Usual magnitude of the period.
    period: f64,
    /// Work of all evaluations.
    pub work: Work,
}

/// How a motion once around depends on its start, its duration and a design variable.
struct Round {
    end: Vec<f64>,
    derivatives: Derivatives,
}

impl GrazingProblem {
    /// The problem near an orbit that nearly grazes.
    pub fn new(plane: Plane, orbit: &Orbit, graze: Graze, scales: [f64; 2]) -> Self {
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
        DVector::from_vec([self.graze.state.as_slice(), &[self.period, p]].concat())
    }

    /// Once around, in at most three pieces.
    fn round(&mut self, flow: &dyn Flow, state: &[f64], period: f64) -> Result<Round, FlowError> {
        let [before, after] = &self.graze.modes;
        let [first, last] = self.graze.held;
        let start = Place {
            state: state.to_vec(),
            modes: after.clone(),
        };
        let (place, lead) = flow.glide(&start, first * period)?;
        let passage = flow.advance(&place, (last - first) * period, Want::DERIVATIVES)?;
        self.work += passage.work;
        if passage.end.modes != *before {
            return Err(FlowError::OtherMode {
                found: spelt(&passage.end.modes),
                wanted: spelt(before),
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
    fn touch(&self, state: &[f64], p: f64, q: f64) -> Result<[f64; 2], FlowError> {
        let flow = self.plane.at(p, q)?;
        let touch = flow.touch(&self.sliding(state), self.graze.contact)?;
        touch.ok_or(FlowError::BadTime { time: 0.0 })
    }

    /// The place of a state in the mode before the graze.
    fn sliding(&self, state: &[f64]) -> Place {
        Place {
            state: state.to_vec(),
            modes: self.graze.modes[0].clone(),
        }
    }
}

/// The derivatives of one motion after another. The motion's own velocity is carried into itself, so that
/// with any share of the time the end moves at its velocity there.
fn chain(first: &Derivatives, second: &Derivatives) -> Derivatives {
    Derivatives {
        state: &second.state * &first.state,
        design: &second.design + &second.state * &first.design,
        time: second.time.clone(),
        trace: first.trace + second.trace,
        factors: Vec::new(),
        lost: first.lost.max(second.lost),
    }
}

/// An orbit at its graze.
#[derive(Debug, Clone, PartialEq)]
pub struct GrazingShot {
    /// The state at the graze.
    pub state: Vec<f64>,
    /// The period.
    pub period: f64,
    /// The rate of the contact's speed there, as it was met.
    pub rate: f64,
    /// Whether the speed is least there, and not largest.
    pub least: bool,
}

impl GrazingProblem {
    /// Speed and rate, with their slopes along all unknowns but the period, and along q.
    fn touches(&self, z: &DVector<f64>, q: f64) -> Result<([f64; 2], DMatrix<f64>), FlowError> {
        let order = self.magnitude.len();
        let at = |z: &DVector<f64>, q: f64| self.touch(&z.as_slice()[..order], z[order + 1], q);
        let scale = self.scale();
        let mut slopes = DMatrix::zeros(2, order + 3);
        for i in (0..order).chain([order + 1, order + 2]) {
            let mut ends = [(z.clone(), q), (z.clone(), q)];
            for ((z, q), sign) in ends.iter_mut().zip([-1.0, 1.0]) {
                if i == order + 2 {
                    *q += sign * DIFFERENCE * self.scales[1];
                } else {
                    z[i] += sign * DIFFERENCE * scale[i];
                }
            }
            let place = |(z, q): &(DVector<f64>, f64)| if i == order + 2 { *q } else { z[i] };
            let width = place(&ends[1]) - place(&ends[0]);
            let [low, high] = [at(&ends[0].0, ends[0].1)?, at(&ends[1].0, ends[1].1)?];
            for row in 0..2 {
                slopes[(row, i)] = (high[row] - low[row]) / width;
            }
        }
        Ok((at(z, q)?, slopes))
    }

    /// Whether the contact, slid on, is faster again.
    fn is_least(&self, state: &[f64], period: f64, p: f64, q: f64) -> Result<bool, FlowError> {
        let flow = self.plane.at(p, q)?;
        let (later, _) = flow.glide(&self.sliding(state), BRIEF * period)?;
        let touch = flow.touch(&later, self.graze.contact)?;
        Ok(touch.is_some_and(|[_, rate]| rate > 0.0))
    }
}

impl ZeroProblem for GrazingProblem {
    type Error = FlowError;
    type Extra = GrazingShot;

    fn evaluate(
        &mut self,
        z: &DVector<f64>,
        q: f64,
    ) -> Result<Linearisation<GrazingShot>, FlowError> {
        let order = self.magnitude.len();
        let state = &z.as_slice()[..order];
        let (period, p) = (z[order], z[order + 1]);
        if !(period > 0.0 && period.is_finite()) {
            return Err(FlowError::BadTime { time: period });
        }
        let along_p = self.plane.along_p(q).at(p)?;
        let round = self.round(&*along_p, state, period)?;
        let along_q = self.plane.along_q(p).at(q)?;
        let across = self.round(&*along_q, state, period)?.derivatives.design;
        let (touch, slopes) = self.touches(z, q)?;
        let n = order + 2;
        let mut linearisation = Linearisation {
            residual: DVector::zeros(n),
            jacobian: DMatrix::zeros(n, n),
            design: DVector::zeros(n),
            extra: GrazingShot {
                state: state.to_vec(),
                period,
                rate: touch[1],
                least: self.is_least(state, period, p, q)?,
            },
        };
        let derivatives = &round.derivatives;
        for i in 0..order {
            let unit = self.magnitude[i];
            linearisation.residual[i] = (round.end[i] - state[i]) / unit;
            for j in 0..order {
                let own = f64::from(i == j);
                linearisation.jacobian[(i, j)] = (derivatives.state[(i, j)] - own) / unit;
            }
            linearisation.jacobian[(i, order)] = derivatives.time[i] / unit;
            linearisation.jacobian[(i, order + 1)] = derivatives.design[i] / unit;
            linearisation.design[i] = across[i] / unit;
        }
        for (row, value) in touch.into_iter().enumerate() {
            let weight = (0..order).map(|j| (slopes[(row, j)] * self.magnitude[j]).abs());
            let unit = weight.sum::<f64>().max(f64::MIN_POSITIVE);
            linearisation.residual[order + row] = value / unit;
            for j in 0..n {
                linearisation.jacobian[(order + row, j)] = slopes[(row, j)] / unit;
            }
            linearisation.design[order + row] = slopes[(row, order + 2)] / unit;
        }
        self.work.newton += 1;
        Ok(linearisation)
    }

    fn scale(&self) -> DVector<f64> {
        let tail = [self.period, self.scales[0]];
        DVector::from_vec([self.magnitude.as_slice(), &tail].concat())
    }

    fn accept(
        &mut self,
        _z: &DVector<f64>,
        _q: f64,
        shot: &GrazingShot,
    ) -> Result<Option<DVector<f64>>, FlowError> {
        self.period = shot.period;
        Ok(None)
    }
}

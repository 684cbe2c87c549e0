//! The zero problem of an orbit on a border between two orders of events.
//!
//! Shooting starts at the border itself. The motion is followed back to it and held in the mode in which it comes there,
//! so that the equations are smooth on both sides of the border and no guard has to fall tangentially: what vanishes at
//! the border vanishes at the start.

use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector};

use super::candidate::{Border, Condition};
use super::round::{Round, chain};
use super::runs::Runs;
use super::sheet::Sheet;
use crate::continuation::{Linearisation, ZeroProblem};
use crate::field::Work;
use crate::flow::{FlowError, Want};
use crate::math::ends;
use crate::motion::{Derivatives, Flow, Place, spelt};
use crate::shooting::Orbit;

/// Step of the differences that give the slopes of what vanishes, relative to the scales.
const DIFFERENCE: f64 = 1e-6;

/// Unknowns are the state at the border, the period and p; q is the design variable.
#[derive(Debug, Clone)]
pub struct BorderProblem<S> {
    pub(super) sheet: S,
    /// The border.
    pub border: Border,
    pub(super) magnitude: Vec<f64>,
    /// Usual magnitudes of p and q.
    scales: [f64; 2],
    /// Usual magnitude of the period.
    period: f64,
    /// What is neutral.
    pub(super) runs: Runs,
    /// Work of all evaluations.
    pub work: Work,
}

impl<S: Sheet> BorderProblem<S> {
    /// The problem near an orbit that is near a border; `None` if it may be shifted though it closes, or if something never
    /// changes where q does, which would leave its middle, or where beyond the border it does.
    pub fn new(sheet: S, orbit: &Orbit, border: Border, scales: [f64; 2]) -> Option<Self> {
        let stays = || sheet.along_q(orbit.r).is_none() && border.is_of_sliding(orbit);
        let free = |runs: &Runs| !runs.conserves() || stays();
        Some(Self {
            runs: Runs::of(orbit).filter(free)?.through(&border.state),
            sheet,
            border,
            magnitude: orbit.magnitude(),
            scales,
            period: orbit.period,
            work: Work::default(),
        })
    }

    /// The unknowns from which to converge.
    #[must_use]
    pub fn unknowns(&self, p: f64) -> DVector<f64> {
        DVector::from_vec([self.border.state.as_slice(), &[self.period, p]].concat())
    }

    /// Once around, or to its image and mirrored: held in its mode up to half of the way to the next event, and from half of
    /// the way from the last one.
    pub(super) fn round(
        &mut self,
        flow: &dyn Flow,
        state: &[f64],
        period: f64,
    ) -> Result<Round, FlowError> {
        let ([first, last], calm) = (self.border.held, self.border.calm);
        let start = self.border.going(state);
        let lead = flow.glide(&start, first * period)?;
        let out = self.on(flow, lead, (calm - first) * period)?;
        let calm = self.on(flow, flow.glide(&out.0, 0.0)?, (last - calm) * period)?;
        if calm.0.modes != *self.border.arriving() {
            return Err(FlowError::OtherMode {
                found: spelt(&calm.0.modes),
                wanted: spelt(self.border.arriving()),
            });
        }
        let (end, rest) = flow.glide(&calm.0, (self.border.turn() - last) * period)?;
        let back = (end, chain(&calm.1, &rest));
        let back = match &self.border.mirror {
            Some(mirror) => mirror.turned(back),
            None => back,
        };
        Ok(Round { out, back })
    }

    /// A motion, and what follows it with whatever happens.
    fn on(
        &mut self,
        flow: &dyn Flow,
        (place, so_far): (Place, Derivatives),
        time: f64,
    ) -> Result<(Place, Derivatives), FlowError> {
        if time <= 0.0 {
            return Ok((place, so_far));
        }
        let passage = flow.advance(&place, time, Want::DERIVATIVES)?;
        self.work += passage.work;
        let on = passage.derivatives.map(|on| chain(&so_far, &on));
        Ok((passage.end, on.unwrap_or(so_far)))
    }

    /// What vanishes at the border.
    fn touch(&self, state: &[f64], p: f64, q: f64) -> Result<[f64; 2], FlowError> {
        let flow = self.sheet.along_p(q).at(p)?;
        let touch = |place| {
            let touch = self.border.touch(&*flow, &place)?;
            touch.ok_or(FlowError::BadTime { time: 0.0 })
        };
        let coming = touch(self.border.coming(state))?;
        match self.border.condition {
            Condition::Touch => Ok(coming),
            Condition::Edge => Ok([coming[0], touch(self.border.stuck(state))?[0]]),
        }
    }

    /// What vanishes, with its slopes along all unknowns but the period, and along q.
    pub(super) fn touches(
        &self,
        z: &DVector<f64>,
        q: f64,
    ) -> Result<([f64; 2], DMatrix<f64>), FlowError> {
        let order = self.magnitude.len();
        let at = |z: &DVector<f64>, q: f64| self.touch(&z.as_slice()[..order], z[order + 1], q);
        let scale = self.scale();
        let mut slopes = DMatrix::zeros(2, order + 3);
        let second = self.sheet.along_q(z[order + 1]).map(|_| order + 2);
        let here = at(z, q)?;
        for i in (0..order).chain([order + 1]).chain(second) {
            let size = if i == order + 2 {
                self.scales[1]
            } else {
                scale[i]
            };
            let beside = [-1.0, 1.0].map(|sign| {
                let (mut z, mut q) = (z.clone(), q);
                let place = if i == order + 2 { &mut q } else { &mut z[i] };
                *place += sign * DIFFERENCE * size;
                (*place, at(&z, q))
            });
            let middle = f64::midpoint(beside[0].0, beside[1].0);
            let [(a, low), (b, high)] = ends((middle, here), beside)?;
            for row in 0..2 {
                slopes[(row, i)] = (high[row] - low[row]) / (b - a);
            }
        }
        Ok((here, slopes))
    }

    /// Whether what only touches zero, held on, rises again; and the rate of the way to the limit at an edge.
    fn beyond(
        &self,
        flow: &dyn Flow,
        state: &[f64],
        period: f64,
    ) -> Result<(bool, f64), FlowError> {
        let (border, contact) = (&self.border, self.border.contact);
        Ok(match border.condition {
            Condition::Touch => (border.rises(flow, state, period)?, 0.0),
            Condition::Edge => {
                let held = flow.touch(&border.stuck(state), contact)?;
                (true, held.map_or(f64::NAN, |[_, rate]| rate))
            }
        })
    }
}

/// An orbit on a border.
#[derive(Debug, Clone, PartialEq)]
pub struct BorderShot {
    /// The state at the border.
    pub state: Vec<f64>,
    /// The period.
    pub period: f64,
    /// The second of the numbers that vanish, as it was met.
    pub rate: f64,
    /// Whether the first is least there, and not largest.
    pub least: bool,
    /// The rate at which a force that could hold the contact comes from its limit, at an edge.
    pub inwards: f64,
    /// What is neutral.
    pub(super) runs: Runs,
}

impl<S: Sheet> ZeroProblem for BorderProblem<S> {
    const AMPLIFIES: bool = true;
    type Error = FlowError;
    type Extra = BorderShot;

    fn evaluate(
        &mut self,
        z: &DVector<f64>,
        q: f64,
    ) -> Result<Linearisation<BorderShot>, FlowError> {
        let (order, n) = (z.len() - 2, z.len());
        let state = &z.as_slice()[..order];
        let (period, p) = (z[order], z[order + 1]);
        if !(period > 0.0 && period.is_finite()) {
            return Err(FlowError::BadTime { time: period });
        }
        let flow = self.sheet.along_p(q).at(p)?;
        let along = self.sheet.along_q(p);
        if along.is_some() {
            self.work += self.border.hold_less(&*flow, state, period)?;
        }
        let round = self.round(&*flow, state, period)?;
        let across = along.map(|along| self.round(&*along.at(q)?, state, period));
        let across = match across.transpose()? {
            Some(across) => across.derivatives().design,
            None => DVector::zeros(order),
        };
        let (touch, slopes) = self.touches(z, q)?;
        let (least, inwards) = self.beyond(&*flow, state, period)?;
        let mut linearisation = Linearisation {
            residual: DVector::zeros(n),
            jacobian: DMatrix::zeros(n, n),
            design: DVector::zeros(n),
            extra: BorderShot {
                state: state.to_vec(),
                period,
                rate: touch[1],
                least,
                inwards,
                runs: self.runs.clone(),
            },
        };
        let derivatives = round.derivatives();
        for i in 0..order {
            let unit = self.magnitude[i];
            let mut gap = round.back.0.state[i] - state[i] - self.runs.gain(i);
            if flow.phase() == Some(i) {
                gap -= TAU * (gap / TAU).round();
            }
            linearisation.residual[i] = gap / unit;
            for j in 0..order {
                let own = f64::from(i == j);
                linearisation.jacobian[(i, j)] = (derivatives.state[(i, j)] - own) / unit;
            }
            linearisation.jacobian[(i, order)] = self.border.turn() * derivatives.time[i] / unit;
            linearisation.jacobian[(i, order + 1)] = derivatives.design[i] / unit;
            linearisation.design[i] = across[i] / unit;
        }
        let runs = self.runs.hold(&mut linearisation, state, &self.magnitude);
        linearisation.extra.runs = runs;
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
        shot: &BorderShot,
    ) -> Result<Option<DVector<f64>>, FlowError> {
        self.period = shot.period;
        Ok(None)
    }
}

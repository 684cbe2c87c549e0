//! Motions that run on: orbits but for a shift that changes nothing.
//!
//! Along a direction d of any shift the gain once around is no condition but a result: with p the state that no other such
//! direction moves, s = (φ − x)ₚ/dₚ is taken out of the equations of all states, and the one of p is free for a condition
//! that holds the orbit along d.

use nalgebra::DVector;

use super::echelon::Free;
use super::lows::section;
use super::pin::Pin;
use super::problem::OrbitProblem;
use super::shift::{keeps_rates, slides, stops};
use super::shot::Shot;
use crate::continuation::Linearisation;
use crate::flow::{FlowError, Peaks, Want};
use crate::motion::{Family, Flow, Place, apart};

/// How near its beginning a motion ends that is told from its section, in usual sizes of the states.
const CLOSED: f64 = 1e-6;

impl OrbitProblem {
    /// Lets orbits that close gain, from now on, along what may be shifted: beyond where friction holds it they run on. What is
    /// free only as long as a press that it would close is open does not, nor does it beyond.
    pub(super) fn may_run(&mut self, flow: &dyn Flow) {
        let mut free = self.pins.iter().filter_map(Pin::along).peekable();
        let any = free.peek().is_some();
        let runs = free.all(|d| stops(flow, d) || slides(flow, d, &self.magnitude));
        if self.shift.is_none() && any && runs {
            self.shift = Some(vec![0.0; self.order()]);
        }
    }

    /// What the states gain besides is a length of the system, which may change with r.
    ///
    /// # Errors
    /// It changes something here.
    pub(super) fn keeps_shift(&self, flow: &dyn Flow) -> Result<(), FlowError> {
        let gained = self
            .shift
            .iter()
            .find(|shift| shift.iter().any(|gain| *gain != 0.0));
        let kept = gained.is_none_or(|shift| keeps_rates(flow, shift, &self.magnitude));
        if kept {
            Ok(())
        } else {
            Err(FlowError::Unshifted)
        }
    }

    /// Lets a motion that runs on gain what it does along each direction of any shift.
    pub(super) fn run(&self, at: &mut Linearisation<Shot>) {
        let Some(mut shift) = at.extra.shift.take() else {
            return;
        };
        run(
            &self.pins,
            (self.closing(), &self.magnitude),
            at,
            &mut shift,
        );
        at.extra.shift = Some(shift);
        at.extra.closure = at.residual.rows(0, at.residual.len() - 1).norm();
    }

    /// Over the equations, where the condition of a pin stands: as its u says, or, where the motion runs on, in the equation
    /// that was taken out.
    pub(super) fn holds(&self, pin: &Pin) -> DVector<f64> {
        match &pin.direction {
            Some((pivot, _)) if self.shift.is_some() => row(self.closing() + pivot, pin.left.len()),
            _ => pin.left.clone(),
        }
    }

    /// Where the equations begin by which the last segment closes the orbit.
    fn closing(&self) -> usize {
        (self.modes.len() - 1) * self.order()
    }
}

impl Shot {
    /// A motion that runs on as it is told: from this place on its section, held there as before, wherever shooting begins.
    ///
    /// `None` where nothing may be shifted at will, where shooting begins there, and where it does not come back from there,
    /// as where errors grow.
    pub(super) fn told(&self, family: &Family, r: f64, place: &Place) -> Option<Self> {
        let shift = self.shift.as_deref()?;
        let mut pins = self.pins.iter().filter(|pin| !pin.conserved()).peekable();
        pins.peek()?;
        if self.starts_on_section() && pins.all(|pin| pin.value == pin.told) {
            return None;
        }
        let mut start = place.clone();
        for pin in &self.pins {
            pin.slide(&mut start.state, pin.told);
        }
        let want = Want {
            extrema: Peaks::Extent(section(self.drive, Some(shift))),
            ..Want::EXTREMA
        };
        let flow = family.at(r).ok()?;
        let passage = flow.advance(&start, self.period, want).ok()?;
        let mut end = passage.end.state.clone();
        for (y, gain) in end.iter_mut().zip(shift) {
            *y -= gain;
        }
        if let Some(phase) = self.drive {
            end[phase] = start.state[phase];
        }
        let told = Self {
            passages: vec![passage],
            velocity: flow.velocity(&start).ok()?,
            start,
            begins: vec![0.0],
            ..self.clone()
        };
        let sizes = told.magnitude(&vec![1.0; end.len()]);
        (apart(&end, &told.start.state, &sizes) <= CLOSED).then_some(told)
    }
}

/// Takes what the states gain along the directions of pins out of the equations of closing, the first of which is `begin`, over
/// these magnitudes, and adds it to the shift.
pub(super) fn run<Extra>(
    pins: &[Pin],
    (begin, magnitude): (usize, &[f64]),
    at: &mut Linearisation<Extra>,
    shift: &mut [f64],
) {
    for free in pins.iter().filter_map(|pin| pin.direction.as_ref()) {
        let along = release((begin, magnitude), at, free);
        let gains = shift.iter_mut().zip(&free.1);
        gains.for_each(|(gain, d)| *gain += along * d);
    }
}

/// The same of one direction, and how much that is. The equation of its state is empty then.
fn release<Extra>(
    (begin, magnitude): (usize, &[f64]),
    at: &mut Linearisation<Extra>,
    (pivot, direction): &Free,
) -> f64 {
    let head = direction[*pivot] / magnitude[*pivot];
    let (gain, rate) = (at.residual[begin + pivot], at.design[begin + pivot]);
    let slopes = at.jacobian.row(begin + pivot).clone_owned();
    for (j, d) in direction.iter().enumerate() {
        let share = d / magnitude[j] / head;
        let share = if j == *pivot { 1.0 } else { share };
        at.residual[begin + j] -= share * gain;
        at.design[begin + j] -= share * rate;
        let rest = at.jacobian.row(begin + j) - &slopes * share;
        at.jacobian.set_row(begin + j, &rest);
    }
    gain / head
}

/// This one of so many equations.
pub(super) fn row(index: usize, equations: usize) -> DVector<f64> {
    DVector::from_fn(equations, |i, _| f64::from(i == index))
}

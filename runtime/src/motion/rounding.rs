//! States that rest, but for what rounding errors of their rates do to them.

use nalgebra::DVector;

use super::{Calm, Flow, Passage, Place};

/// A swing below this share of what is usual for a state is looked at: it may be all rounding.
const SUSPECT: f64 = 1e-9;
/// What errors of one sign at every instant would add up to, and this many times as much, is rounding.
const SURE: f64 = 16.0;
/// Share of what is usual for states by which they are moved, in these proportions, to see how rates are rounded.
const NEAR: f64 = 1e-12;
const SHIFTS: [f64; 6] = [1.0, -2.0, 3.0, -1.0, 2.0, -3.0];

impl Passage {
    /// The same with states at rest that only rounding moves. In rates that large terms leave by cancelling, as weight and
    /// springs do, these are no small numbers: taken for swings, they were what a state is measured against.
    pub(super) fn without_rounding(mut self, flow: &dyn Flow, from: &Place, usual: &[f64]) -> Self {
        let swing = |calm: &Calm, j: usize| calm.high[j] - calm.low[j];
        let suspect = |j: &usize| {
            let swing = swing(&self.calm, *j);
            swing > 0.0 && swing < SUSPECT * usual[*j]
        };
        let mut suspects = (0..usual.len()).filter(suspect).peekable();
        if suspects.peek().is_none() {
            return self;
        }
        let Some(floors) = floors(flow, from, usual, self.time) else {
            return self;
        };
        let rests = |j: &usize| swing(&self.calm, *j) <= floors[*j];
        let resting: Vec<usize> = suspects.filter(rests).collect();
        for &j in &resting {
            let place = from.state[j];
            let at = if place.abs() <= floors[j] { 0.0 } else { place };
            (self.calm.low[j], self.calm.high[j]) = (at, at);
        }
        self.extrema.retain(|one| !resting.contains(&one.index));
        self
    }
}

/// How far rounding may move each state in a time, by itself and by way of those that it moves: what of the rates nearby is
/// no linear function.
fn floors(flow: &dyn Flow, from: &Place, usual: &[f64], time: f64) -> Option<Vec<f64>> {
    let here = flow.velocity(from).ok()?;
    let state = DVector::from_column_slice(&from.state);
    let mut noise = DVector::zeros(state.len());
    for probe in 0..SHIFTS.len() {
        let shift =
            |j: usize| SHIFTS[(j + probe) % SHIFTS.len()] * NEAR * usual[j].max(state[j].abs());
        let there = DVector::from_fn(state.len(), |j, _| state[j] + shift(j));
        let place = Place {
            state: there.iter().copied().collect(),
            modes: from.modes.clone(),
        };
        let rates = flow.velocity(&place).ok()?.f;
        noise = noise.sup(&(rates - &here.f - &here.jacobian * (there - &state)).abs());
    }
    let own = noise * (SURE * time);
    let passed_on = here.jacobian.abs() * &own * time;
    Some(own.sup(&passed_on).iter().copied().collect())
}

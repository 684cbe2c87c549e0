//! The motion once around of an orbit on its border, in pieces that end there.
//!
//! Whether the event of a touch happens on it is a matter of rounding errors: each piece begins beyond it. What holds a
//! contact is just at its limit there, and does not fall any more: only a little later it is certain to hold.

use nalgebra::DVector;

use super::candidate::{Border, Condition};
use super::problem::BorderProblem;
use super::runs::Runs;
use crate::flow::{FlowError, Want};
use crate::motion::{Event, Family, Flow, Passage, Place};
use crate::shooting::shot::Shot;

/// Share of the period for which what holds a contact is not asked whether it does.
const HELD: f64 = 1e-5;

impl BorderProblem<Family> {
    /// Once around from this place, where all is calm.
    ///
    /// # Errors
    /// The motion cannot be followed.
    pub(super) fn shot(
        &self,
        flow: &dyn Flow,
        z: &DVector<f64>,
        start: &Place,
        runs: &Runs,
    ) -> Result<Shot, FlowError> {
        let order = z.len() - 2;
        let (later, period) = (runs.later(&z.as_slice()[..order]), z[order]);
        let runs = runs.through(&start.state);
        Ok(Shot {
            begins: vec![0.0],
            passages: vec![once(flow, &self.border, (start, &later), period)?],
            velocity: flow.velocity(start)?,
            start: start.clone(),
            period,
            drive: flow.phase(),
            closure: 0.0,
            pins: runs.pins,
            shift: runs.shift,
        })
    }
}

/// From a calm start to the image of the border, if there is one, from there to the border, and back.
///
/// # Errors
/// The motion cannot be followed.
fn once(
    flow: &dyn Flow,
    border: &Border,
    (start, state): (&Place, &[f64]),
    period: f64,
) -> Result<Passage, FlowError> {
    let (on, calm, turn) = (border.going(state), border.calm, border.turn());
    if border.condition == Condition::Edge && border.mirror.is_none() {
        return flow.advance(start, period, Want::EXTREMA);
    }
    let image = border.mirror.as_ref().map(|mirror| mirror.image(flow, &on));
    let mut all = flow.advance(start, (turn - calm) * period, Want::EXTREMA)?;
    let held = if border.after().binds() { HELD } else { 0.0 };
    let pieces = image.map(|image| (image, turn)).into_iter();
    for (place, share) in pieces.chain([(on, calm)]) {
        let (beyond, _) = flow.glide(&place, held * period)?;
        all.time += held * period;
        let rest = flow.advance(&beyond, (share - held) * period, Want::EXTREMA)?;
        join(&mut all, rest);
    }
    Ok(all)
}

/// What follows a motion becomes part of it.
fn join(all: &mut Passage, next: Passage) {
    let before = all.time;
    all.extrema.extend(next.extrema.into_iter().map(|mut one| {
        one.time += before;
        one
    }));
    all.events.extend(next.events.into_iter().map(|one| Event {
        time: before + one.time,
        ..one
    }));
    for j in 0..all.calm.low.len() {
        all.calm.low[j] = all.calm.low[j].min(next.calm.low[j]);
        all.calm.high[j] = all.calm.high[j].max(next.calm.high[j]);
    }
    all.segments.extend(next.segments);
    all.rounding = all.rounding.max(next.rounding);
    all.time += next.time;
    all.work += next.work;
    all.end = next.end;
}

//! Motions that repeat but for a shift of states on which nothing depends: an angle that turns, a chain that creeps.

use nalgebra::DVector;

use super::ground::{Ground, ROUGH};
use super::record::{Attractor, Class};
use crate::bifurcation::floquet;
use crate::equilibrium::Spectrum;
use crate::flow::{FlowError, Want};
use crate::motion::{Passage, apart, sticking};
use crate::shooting::{changes_nothing, slides};

/// Most crossings in one period.
const LONGEST: usize = 8;
/// Returns that agree to this, in usual sizes, have settled.
const SETTLED: f64 = 1e-9;
/// Returns that agree to this may be about to settle.
const NEAR: f64 = 1e-6;
/// A state that advances less, in usual sizes, does not run.
const RUNS: f64 = 1e-5;
/// Accuracy at which its multipliers are computed.
const SHARP: f64 = 1e-10;

/// A crossing of the section: when, and where.
pub(super) type Crossing = (f64, Vec<f64>);

/// The running motion that has settled in these crossings of the section of a state; `None` if it is none.
pub(super) fn running(
    ground: &Ground<'_>,
    section: usize,
    crossings: &[Crossing],
) -> Result<Option<Attractor>, FlowError> {
    let returned = |k: usize, closeness: f64| {
        let shift = advance(ground, (k, closeness), crossings)?;
        changes_nothing(ground.flow.as_ref(), &shift, &ground.usual).then_some((k, shift))
    };
    let Some((count, shift)) = (1..=LONGEST).find_map(|k| returned(k, SETTLED)) else {
        return Ok(None);
    };
    // What settles to and fro comes back after two turns before it does after one.
    let mut parts = (1..count).filter(|k| count.is_multiple_of(*k));
    if parts.any(|k| returned(k, NEAR).is_some()) {
        return Ok(None);
    }
    let last = &crossings[crossings.len() - count - 1..];
    let period = last[count].0 - last[0].0;
    read(ground, section, last, (period, shift)).map(Some)
}

/// The motion of a passage if all its rates are constant, and nothing depends on where it is: what slides on and on.
pub(super) fn steady(
    ground: &Ground<'_>,
    passage: &Passage,
) -> Result<Option<Attractor>, FlowError> {
    let flow = ground.flow.as_ref();
    if flow.phase().is_some() || !passage.extrema.is_empty() {
        return Ok(None);
    }
    let [before, after] = [&passage.calm.place, &passage.end].map(|place| flow.velocity(place));
    let (before, after) = (before?, after?);
    let rates = after.f.as_slice();
    // A shift of a usual size.
    let fastest = rates
        .iter()
        .zip(&ground.usual)
        .map(|(rate, usual)| (rate / usual).abs());
    let time = 1.0 / fastest.fold(0.0, f64::max);
    let shifted: Vec<f64> = rates.iter().map(|rate| time * rate).collect();
    let constant = (&before.f - &after.f).amax() <= SETTLED * after.f.amax();
    if !(constant && time.is_finite() && slides(flow, &shifted, &ground.usual)) {
        return Ok(None);
    }
    let mut found = Attractor::bare(Class::Running, &passage.end.state, None);
    let spectrum = Spectrum::across(
        &after.jacobian,
        1 + sticking(&passage.end.modes) + after.lost,
    );
    found.word = ground.word(&passage.segments);
    found.modes = passage.end.modes.clone();
    found.shift = Some(rates.to_vec());
    Ok(Some(
        found.judged(&spectrum.eigenvalues, spectrum.stability),
    ))
}

/// What the states gain in the last two times `count` crossings alike to this closeness, if some do.
fn advance(
    ground: &Ground<'_>,
    (count, closeness): (usize, f64),
    crossings: &[Crossing],
) -> Option<Vec<f64>> {
    let from = |back: usize| {
        crossings
            .len()
            .checked_sub(back * count + 1)
            .map(|i| &crossings[i].1)
    };
    let (a, b, c) = (from(0)?, from(1)?, from(2)?);
    let gain = |later: &[f64], before: &[f64]| {
        let usual = &ground.usual;
        let gain = |j: usize| later[j] - before[j];
        // A phase that turns is where it was; what gains no more than it has settled gains nothing.
        let runs = |j: usize| ground.flow.phase() != Some(j) && gain(j).abs() > RUNS * usual[j];
        let settled = (0..usual.len()).all(|j| runs(j) || gain(j).abs() <= closeness * usual[j]);
        let gain = |j: usize| if runs(j) { gain(j) } else { 0.0 };
        settled.then(|| (0..usual.len()).map(gain).collect::<Vec<f64>>())
    };
    let (new, old) = (gain(a, b)?, gain(b, c)?);
    let runs = new.iter().any(|gain| *gain != 0.0);
    (runs && apart(&new, &old, &ground.usual) <= closeness).then_some(new)
}

/// The motion between the first and the last of these crossings.
fn read(
    ground: &Ground<'_>,
    section: usize,
    crossings: &[Crossing],
    (period, shift): (f64, Vec<f64>),
) -> Result<Attractor, FlowError> {
    let state = &crossings[0].1;
    let flow = ground.flow.as_ref();
    let place = flow.place(state)?;
    let want = Want {
        factors: flow.order() > 2,
        ..Want::SHOT
    };
    let passage = flow.advance(&place, period, want)?;
    let velocity = flow.velocity(&place)?.f;
    let slides = slides(flow, &shift, &ground.usual);
    let mut found = Attractor::bare(Class::Running, state, None);
    for extremum in &passage.extrema {
        for (j, y) in extremum.state.iter().enumerate() {
            found.min[j] = found.min[j].min(*y);
            found.max[j] = found.max[j].max(*y);
        }
    }
    if let Some(derivatives) = &passage.derivatives {
        let stuck = passage
            .segments
            .iter()
            .map(|segment| sticking(&segment.modes))
            .max();
        let zeros = stuck.unwrap_or(0).max(derivatives.lost);
        let velocity = DVector::from_column_slice(velocity.as_slice());
        let floquet = floquet(
            &derivatives.state,
            &velocity,
            Some(derivatives.determinant),
            zeros,
            &derivatives.factors,
            usize::from(slides),
            SHARP,
        );
        found = found.judged(&floquet.multipliers, floquet.stability);
    }
    found.word = ground.word(&passage.segments);
    found.points = crossings[1..]
        .iter()
        .map(|(_, state)| state.clone())
        .collect();
    found.error = Some(ROUGH);
    found.section = section;
    found.modes = place.modes;
    found.period = Some(period);
    found.slides = slides;
    found.shift = Some(shift);
    Ok(found)
}

//! What never changes along a motion, and what may be shifted without changing it.

use nalgebra::DVector;

use super::shot::Shot;
use crate::flow::FlowError;
use crate::motion::{Contacts, Flow, Modes, Place, Velocity};

/// Share of its terms below which a sum of rates is none.
const ROUNDING: f64 = 1e-8;
/// The same where all of them vanish, of what they are elsewhere.
const VANISHING: f64 = 1e-14;

/// Whether a combination of the states has no rate anywhere on the way, nor beside it: two alike that move alike have none
/// on it. Where all its terms vanish, rounding is left of them, which is measured by what they are elsewhere, and by what
/// would be usual.
pub(super) fn is_conserved(
    flow: &dyn Flow,
    combination: &[f64],
    shot: &Shot,
    magnitude: &[f64],
) -> bool {
    let Some(all) = along(shot, |place| flow.contacts(place)) else {
        return false;
    };
    let terms = |at: &Contacts| -> Vec<f64> {
        let rates = combination.iter().zip(&at.f);
        rates.map(|(c, rate)| c * rate).collect()
    };
    let rates: Vec<Vec<f64>> = all.iter().map(|(_, at)| terms(at)).collect();
    let size = |terms: &Vec<f64>| terms.iter().map(|term| term.abs()).sum::<f64>();
    let usual = combination.iter().zip(magnitude);
    let usual: f64 = usual.map(|(c, unit)| (c * unit).abs()).sum();
    let most = rates.iter().map(size).fold(usual / shot.period, f64::max);
    let rounding = VANISHING * most;
    let none =
        |terms: &Vec<f64>| terms.iter().sum::<f64>().abs() <= rounding.max(ROUNDING * size(terms));
    let flat =
        |(place, at): &(Place, Contacts)| is_flat(combination, at, &place.modes, magnitude, None);
    rates.iter().all(none) && all.iter().all(flat)
}

/// Whether the rate of a combination depends on the phase of a drive alone, all along the way and beside it: what friction holds
/// to a shaken ground. Of a motion that closes it gains nothing in a period, wherever it begins.
pub(super) fn is_driven(
    flow: &dyn Flow,
    combination: &[f64],
    shot: &Shot,
    magnitude: &[f64],
) -> bool {
    let phase = flow.phase();
    let flat =
        |(place, at): &(Place, Contacts)| is_flat(combination, at, &place.modes, magnitude, phase);
    let all = along(shot, |place| flow.contacts(place));
    phase.is_some() && all.is_some_and(|all| all.iter().all(flat))
}

/// Whether the rate of a combination is the same in all states beside this one in which the same contacts stick, and a drive is
/// where it is: its slopes are sums of those of their speeds.
fn is_flat(
    combination: &[f64],
    at: &Contacts,
    modes: &Modes,
    magnitude: &[f64],
    phase: Option<usize>,
) -> bool {
    let order = magnitude.len();
    let unit = |j: usize| if Some(j) == phase { 0.0 } else { magnitude[j] };
    let term = |i: usize, j: usize| combination[i] * at.jacobian[(i, j)] * unit(j);
    let mut slopes = DVector::from_fn(order, |j, _| (0..order).map(|i| term(i, j)).sum());
    let terms = (0..order).flat_map(|i| (0..order).map(move |j| (i, j)));
    let size: f64 = terms.map(|(i, j)| term(i, j).abs()).sum();
    let mut known: Vec<DVector<f64>> = Vec::new();
    for contact in (0..modes.len()).filter(|&i| modes[i].binds()) {
        let speed = &at.all[contact].speed.slopes;
        let mut speed = DVector::from_fn(order, |j, _| speed[j] * unit(j));
        let whole = speed.norm();
        known.iter().for_each(|known| take_out(known, &mut speed));
        if speed.normalize_mut() > ROUNDING * whole {
            known.push(speed);
        }
    }
    known.iter().for_each(|known| take_out(known, &mut slopes));
    slopes.amax() <= ROUNDING * size
}

/// Takes out of a vector what it has of this unit vector.
fn take_out(unit: &DVector<f64>, of: &mut DVector<f64>) {
    let share = unit.dot(of);
    of.axpy(-share, unit, 1.0);
}

/// Whether no rate depends on where the states are along a shift, given in units of the unknowns, anywhere on the way.
pub(super) fn is_free(
    flow: &dyn Flow,
    shift: &DVector<f64>,
    magnitude: &[f64],
    shot: &Shot,
) -> bool {
    let still = |velocity: &Velocity| {
        velocity.jacobian.row_iter().all(|row| {
            let terms = || (0..magnitude.len()).map(|j| row[j] * shift[j] * magnitude[j]);
            let size = (0..magnitude.len()).map(|j| (row[j] * magnitude[j]).abs());
            terms().sum::<f64>().abs() <= ROUNDING * size.sum::<f64>()
        })
    };
    along(shot, |place| flow.velocity(place))
        .is_some_and(|all| all.iter().all(|(_, velocity)| still(velocity)))
}

/// What is told where the motion begins, and where any state turns.
fn along<T>(shot: &Shot, told: impl Fn(&Place) -> Result<T, FlowError>) -> Option<Vec<(Place, T)>> {
    let turns = shot.passages.iter().flat_map(|passage| {
        let turns = passage.extrema.iter().map(|turn| (turn.time, &turn.state));
        passage.places(turns)
    });
    let tell = |place: Place| {
        let told = told(&place)?;
        Ok((place, told))
    };
    let all = std::iter::once(shot.start.clone()).chain(turns).map(tell);
    all.collect::<Result<_, FlowError>>().ok()
}

//! Motions that change their mode all along at once, as a rotor does whose circle grows to the gap about it: no event on the
//! way tells such a point, and beyond it none of the orbit is as before.

use super::begin::begin;
use super::converge::converge;
use super::grip::{near, once, passes};
use super::guess::Guess;
use super::orbit::Orbit;
use super::problem::OrbitProblem;
use super::rest::settles;
use crate::bifurcation::Kind;
use crate::continuation::{Branch, Crossing, Failure, Stop, Watched};
use crate::flow::FlowError;
use crate::motion::{Family, Modes};

/// How far beyond an orbit of another mode is sought, over r.
const BEYOND: [f64; 3] = [1e-6, 1e-5, 1e-4];
/// How far it may be from the last one, by their extents, over that.
const FAR: f64 = 100.0;

/// The point after the last of these orbits, each of one mode all along, at which that becomes another one, and the orbits
/// beyond, if any are found: what is thrown back may not come to any. `None` if it becomes none.
pub(super) fn changes_at_once(
    branch: &Branch<OrbitProblem>,
    orbits: &[Orbit],
    accuracy: f64,
) -> Option<Crossing<OrbitProblem, Orbit>> {
    let [.., before, last] = orbits else {
        return None;
    };
    if !comes_back_otherwise(branch) {
        return None;
    }
    mode(before)?;
    let modes = mode(last)?;
    let (family, settings) = (&branch.problem.family, branch.settings());
    let search = near(last, accuracy);
    let way = (last.r - before.r).signum();
    let found = BEYOND.into_iter().find_map(|far| {
        let r = last.r + far * way * last.r_size();
        let guess = settings
            .contains(r)
            .then(|| guess(family, [before, last], r))??;
        let found = converge(family, r, &guess, &search).ok()?;
        let new = mode(&found).is_some_and(|found| found != modes);
        (new && last.apart(&found) <= FAR * far).then_some((r, found))
    });
    let started = found
        .as_ref()
        .and_then(|(r, found)| begin(family, found, &search, settings, (*r, way > 0.0)).ok());
    let changes = |k: &usize| {
        found
            .as_ref()
            .is_none_or(|(_, new)| new.place.modes[*k] != modes[*k])
    };
    let mut changed = (0..modes.len()).filter(changes);
    let kind = match changed.any(|k| modes[k].is_of_press()) {
        true => Kind::Grazing,
        false => Kind::GrazingSliding,
    };
    let apart = (last.r - before.r).abs();
    Some(passes(last, (kind, last.r, apart), started, accuracy))
}

/// Whether it is for their mode that motions beyond are no orbits, however short the step.
fn comes_back_otherwise(branch: &Branch<OrbitProblem>) -> bool {
    match branch.stop() {
        Some(Stop::Refused(why) | Stop::StepTooSmall(Failure::Evaluation(why))) => {
            matches!(
                why,
                FlowError::OtherMode { .. } | FlowError::InconsistentMode { .. }
            )
        }
        _ => false,
    }
}

/// The modes of the contacts, if they are the same all along.
fn mode(orbit: &Orbit) -> Option<&Modes> {
    let modes = &orbit.place.modes;
    let mut segments = orbit.segments.iter();
    segments.all(|one| one.modes == *modes).then_some(modes)
}

/// Where the motion settles at r to which these two lead: it may bounce before.
fn guess(family: &Family, [before, last]: [&Orbit; 2], r: f64) -> Option<Guess> {
    let mut guess = last.guess();
    let ahead = (r - last.r) / (last.r - before.r);
    let states = guess.place.state.iter_mut().zip(&before.place.state);
    states.for_each(|(x, old)| *x += ahead * (*x - old));
    let flow = family.with_magnitude(&guess.magnitude).at(r).ok()?;
    guess.place = flow.place(&guess.place.state).ok()?;
    guess.period = once(flow.as_ref(), &guess.place, guess.period)?;
    guess.division = None;
    let place = settles(flow.as_ref(), &guess, |_| true)?;
    Some(Guess { place, ..guess })
}

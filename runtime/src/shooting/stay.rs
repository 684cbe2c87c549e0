//! Whether a motion stays on an orbit beside which it comes back.

use super::error::OrbitError;
use super::guess::Guess;
use super::moved::unshifted;
use super::orbit::Orbit;
use crate::bifurcation::Stability;
use crate::flow::FlowError;
use crate::motion::{Family, Flow};
use crate::poincare::{Crossings, Horizon, Section, once_around};

/// Distances are in half extents. A motion this close to an orbit is on it.
const ON: f64 = 1e-5;
/// Nothing is known of an orbit from a motion further away than this.
const NEAR: f64 = 0.1;
/// Share to which the distance to a stable orbit is to fall while the motion is watched.
const FALL: f64 = 0.5;
/// Most turns around the orbit for which it is watched.
const LAPS: f64 = 1000.0;

/// Whether the motion from `start` stays on the orbit that was found near its return: it begins there, or is drawn to it.
pub(super) fn stays(
    family: &Family,
    r: f64,
    guess: &Guess,
    (orbit, start): (&Orbit, &[f64]),
) -> Result<bool, OrbitError> {
    let family = family.with_magnitude(&guess.magnitude);
    let flow = family.at(r)?;
    if orbit.floquet.stability == Stability::Unstable {
        return Ok(begins(flow.as_ref(), start, guess, orbit)?);
    }
    Ok(approaches(flow.as_ref(), guess, orbit)?)
}

/// Whether the start lies on the orbit: in one period of it, it comes back to itself and passes the orbit's own start.
fn begins(flow: &dyn Flow, start: &[f64], guess: &Guess, orbit: &Orbit) -> Result<bool, FlowError> {
    let place = flow.place(start)?;
    let end = flow.advance(&place, orbit.period, Default::default())?.end;
    if orbit.far(&end.state, start, guess, flow.phase()) > ON {
        return Ok(false);
    }
    let section = orbit.usual_section(flow.phase());
    let met = once_around(flow, place, section, orbit.period)?;
    let near = |state: &[f64]| to_orbit(state, orbit, guess, flow.phase()) <= ON;
    Ok(met.points.iter().any(|crossing| near(&crossing.state)))
}

/// Whether the distance to a stable orbit falls as its multipliers say.
fn approaches(flow: &dyn Flow, guess: &Guess, orbit: &Orbit) -> Result<bool, FlowError> {
    let apart = |state: &[f64]| to_orbit(state, orbit, guess, flow.phase());
    let section = orbit.usual_section(flow.phase());
    let mut crossings = Crossings::new(flow, guess.place.clone(), section, Horizon::Recurrence)?;
    // A motion that runs on may have been seen to come back where another state is least.
    let first = match orbit.shift {
        Some(_) => crossings.next().transpose()?,
        None => None,
    };
    let first = first.map_or_else(|| guess.place.state.clone(), |crossing| crossing.state);
    let before = apart(&first);
    let undecided = orbit.floquet.stability == Stability::Undecided;
    if before > NEAR || before <= ON && !undecided {
        return Ok(before <= ON);
    }
    let largest = orbit.floquet.growth();
    let laps = (FALL.ln() / largest.ln()).ceil();
    let laps = match laps {
        // Multipliers that decide nothing say nothing of how soon either.
        _ if undecided => 1.0,
        laps if laps >= 1.0 => laps.min(LAPS),
        _ => LAPS,
    };
    let count = laps as usize * orbit.section.len().max(1);
    match crossings.nth(count - 1) {
        Some(crossing) if undecided => Ok(apart(&crossing?.state) <= (2.0 * before).max(ON)),
        Some(crossing) => Ok(apart(&crossing?.state) <= 0.5 * (1.0 + largest.powf(laps)) * before),
        None => Ok(undecided),
    }
}

/// The distance of a point of the section to the nearest one of the orbit.
fn to_orbit(state: &[f64], orbit: &Orbit, guess: &Guess, phase: Option<usize>) -> f64 {
    let points = orbit.section.iter().chain([&orbit.place.state]);
    let distances = points.map(|point| orbit.far(state, point, guess, phase));
    distances.fold(f64::INFINITY, f64::min)
}

impl Orbit {
    /// The section on which its points lie.
    fn usual_section(&self, phase: Option<usize>) -> Section {
        match phase {
            Some(_) => Section::usual(phase),
            None => Section::least(self.crossed(None)),
        }
    }

    /// The distance of a state from a point, but for the phase of a drive, and for shifts that change nothing where it runs on.
    fn far(&self, state: &[f64], point: &[f64], guess: &Guess, phase: Option<usize>) -> f64 {
        let moved = self.shift.as_ref();
        let moved = moved.map(|shift| self.slid(unshifted(state, point, shift), point));
        let state = moved.as_deref().unwrap_or(state);
        let states = (0..state.len()).filter(|j| phase != Some(*j));
        let share = |j: usize| (state[j] - point[j]).abs() / guess.magnitude[j];
        states.map(share).fold(0.0, f64::max)
    }
}

//! Contacts that slide ever less along a branch, until friction holds them all along.
//!
//! Where the force on a contact exceeds its limit by ε for a moment, it slides for a time that grows with √ε: the square of
//! that time falls to zero with r. Near there a multiplier is 1 but for √ε, and slides are noise in the end; so the branch is
//! taken up again a little beyond, among the orbits that are held.

use std::f64::consts::TAU;

use super::begin::begin;
use super::converge::converge;
use super::guess::Guess;
use super::orbit::Orbit;
use super::problem::OrbitProblem;
use super::search::Search;
use crate::continuation::{Beyond, Branch, Crossing, Kind, Located};
use crate::field::exact::Mode;
use crate::flow::Want;
use crate::math::at_zero;
use crate::motion::{Family, Flow, Place, apart};

/// Share of the period below which it is looked at whether sliding vanishes.
const SHORT: f64 = 0.03;
/// How far two extrapolations may be apart, as a share of the way to where they lead.
const APART: f64 = 0.05;
/// How far beyond the orbits are held for certain, over the same way.
const BEYOND: f64 = 2.0;
/// What the errors of three orbits may add up to, over one of them.
const NOISE: f64 = 10.0;
/// Periods after which it is looked whether a motion has lost what it brought along, how often, and how well it repeats then.
const SETTLES: f64 = 20.0;
const LOOKS: usize = 100;
const REPEATS: f64 = 1e-8;
/// Relative change of the period up to which an orbit that is held is that to which the branch comes. What slides has hardly
/// an extent, by which orbits could be compared.
const REACH: f64 = 1e-2;

/// Where sliding vanishes.
#[derive(Debug, Clone, Copy)]
struct Rest {
    contact: usize,
    r: f64,
    error: f64,
}

/// The point after the last of these orbits at which a contact comes to rest for good, and the orbits beyond; `None` if none
/// does so next.
pub(super) fn comes_to_rest(
    branch: &Branch<OrbitProblem>,
    orbits: &[Orbit],
    accuracy: f64,
) -> Option<Crossing<OrbitProblem, Orbit>> {
    let [.., first, second, last] = orbits else {
        return None;
    };
    let rest = rest([first, second, last])?;
    let settings = branch.settings();
    let upwards = rest.r > last.r;
    let r = beyond(rest.r, rest.r - last.r, [settings.from, settings.to])?;
    let search = Search {
        start: last.place.state.clone(),
        period: Some(last.period),
        accuracy,
        segments: 1,
    };
    let family = &branch.problem.family;
    let held = held(family, r, (last, rest.contact), &search)?;
    let started = begin(family, &held, &search, settings, (r, upwards)).ok()?;
    let mut located = Located::at(Kind::VanishingSegment, rest.r, last.clone());
    (located.point.r, located.error) = (rest.r, rest.error + NOISE * accuracy * rest.r.abs());
    Some(Crossing {
        located,
        beyond: Beyond::Onwards(Box::new(started)),
    })
}

/// Where the sliding of a contact vanishes, as three orbits that follow each other show.
fn rest(orbits: [&Orbit; 3]) -> Option<Rest> {
    let contacts = orbits[2].place.modes.len();
    let rest = |contact: usize| {
        let squares = orbits.map(|orbit| (slides(orbit, contact).powi(2), orbit.r));
        let [(x, _), (y, q), (z, r)] = squares;
        let found = at_zero(squares);
        let [near, far] = found.lines;
        let falls = x > y && y > z && z > 0.0 && z <= SHORT * SHORT;
        let leads = (near - far).abs() <= APART * (near - r).abs() && (near - r) * (r - q) > 0.0;
        (falls && leads).then(|| Rest {
            contact,
            r: found.value,
            error: (found.value - near).abs(),
        })
    };
    (0..contacts).find_map(rest)
}

/// A place beyond r in the range, next to it on this way; `None` if r is not inside.
fn beyond(r: f64, way: f64, [from, to]: [f64; 2]) -> Option<f64> {
    let inside = |r: f64| (r - from) * (r - to) < 0.0;
    let end = if (to - from) * way > 0.0 { to } else { from };
    let far = r + BEYOND * way;
    let within = if inside(far) {
        far
    } else {
        f64::midpoint(r, end)
    };
    inside(r).then_some(within)
}

/// For which share of its period a contact slides.
fn slides(orbit: &Orbit, contact: usize) -> f64 {
    let slides = orbit.segments.iter();
    let slides = slides.filter(|segment| segment.modes[contact] != Mode::Stick);
    slides.map(|segment| segment.duration).sum::<f64>() / orbit.period
}

/// The orbit at r on which the motion from this one settles, if friction holds the contact there all along.
fn held(
    family: &Family,
    r: f64,
    (from, contact): (&Orbit, usize),
    search: &Search,
) -> Option<Orbit> {
    let guess = from.guess();
    let flow = family.with_magnitude(&guess.magnitude).at(r).ok()?;
    let mut place = flow.place(&guess.place.state).ok()?;
    let period = once(flow.as_ref(), &place, guess.period)?;
    for _ in 0..LOOKS {
        let settled = flow.advance(&place, SETTLES * period, Want::default());
        place = settled.ok()?.end;
        place.state = flow.wrapped(place.state);
        let again = flow.advance(&place, period, Want::EXTREMA).ok()?;
        let mut own = again.events.iter().filter(|event| event.contact == contact);
        if own.any(|event| event.switches()) {
            return None;
        }
        let mut end = again.end.state;
        if let Some(phase) = flow.phase() {
            end[phase] = place.state[phase];
        }
        if apart(&place.state, &end, &guess.magnitude) <= REPEATS {
            break;
        }
    }
    let guess = Guess {
        place,
        period,
        ..guess
    };
    let found = converge(family, r, &guess, search).ok()?;
    let held = slides(&found, contact) == 0.0 && !found.pins.is_empty();
    let near = (found.period / from.period - 1.0).abs() <= REACH;
    (held && near).then_some(found)
}

/// The time after which a motion of about this period is to repeat: the drive turns as often as before.
fn once(flow: &dyn Flow, place: &Place, about: f64) -> Option<f64> {
    let Some(phase) = flow.phase() else {
        return Some(about);
    };
    let turn = TAU / flow.velocity(place).ok()?.f[phase];
    Some(turn * (about / turn).round().max(1.0))
}

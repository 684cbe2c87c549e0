//! Contacts that slide ever less along a branch, until friction holds them all along.
//!
//! Where the force on a contact exceeds its limit by ε for a moment, it slides for a time that grows with √ε, where it does so
//! for a while, hardly less: but the mean acceleration of its slides falls to zero with r either way. Near there a multiplier
//! is 1 but for √ε, and slides are noise in the end; so the branch is taken up again a little beyond, among the orbits that are
//! held, and it is these that tell the point, by how near they are to letting go.

use nalgebra::DVector;

use super::begin::begin;
use super::converge::converge;
use super::grip::{keeps_mode, near, once, passes, reaches, slides, way};
use super::guess::Guess;
use super::orbit::Orbit;
use super::problem::OrbitProblem;
use super::sought::Search;
use super::swing::spare_force;
use crate::continuation::{
    Branch, Crossing, Kind, Settings, Started, Watched, ZeroProblem, correct_at,
};
use crate::field::exact::Mode;
use crate::flow::Want;
use crate::math::at_zero;
use crate::motion::{Family, Flow, Passage, Place, apart};

/// Steps that become shorter than this share of the one before are looked at, where their urge to slide falls below this
/// share within two of them.
const SLOWER: f64 = 0.95;
const LESS: f64 = 0.9;
/// How far two extrapolations may be apart, as a share of the way to where they lead.
const APART: f64 = 0.05;
/// How far beyond orbits are sought that are held, over the same way: next to the point those alone are that strain the contact
/// as much the one way as the other.
const BEYOND: [f64; 4] = [2.0, 8.0, 32.0, 128.0];
/// How far away, relatively, the orbit is from which one that has come to a border is continued.
const AWAY: f64 = 1e-3;
/// Orbits beyond by which it is located, as shares of the way to the first of them, then ever closer.
const NEARER: [f64; 3] = [1.0, 0.5, 0.25];
const CLOSER: [f64; 2] = [1.0 / 16.0, 1.0 / 256.0];
/// Periods after which it is looked whether a motion has lost what it brought along, how often, and how well it repeats then.
const SETTLES: f64 = 20.0;
const LOOKS: usize = 100;
const REPEATS: f64 = 1e-8;

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
    let rest = rest(&branch.problem.family, [first, second, last])?;
    rest.passes(branch, [second, last], rest.r - last.r, accuracy)
}

/// The same where a border has been found at r at which a contact should cease to slide, and no orbits beyond it along which
/// it slides.
pub(super) fn rests_beyond(
    branch: &Branch<OrbitProblem>,
    orbits: &[Orbit],
    (r, error): (f64, f64),
    accuracy: f64,
) -> Option<Crossing<OrbitProblem, Orbit>> {
    let (last, before) = orbits.split_last()?;
    let far = |orbit: &&Orbit| (orbit.r - r).abs() >= AWAY * last.r_size();
    let from = before.iter().rev().find(far)?;
    let slides = (0..last.place.modes.len()).filter(|contact| slides(last, *contact) > 0.0);
    let mut rests = slides.map(|contact| Rest { contact, r, error });
    rests.find_map(|rest| rest.passes(branch, [from, last], r - from.r, accuracy))
}

/// Where the sliding of a contact vanishes, as three orbits that follow each other ever more closely show.
fn rest(family: &Family, orbits: [&Orbit; 3]) -> Option<Rest> {
    let [p, q, r] = orbits.map(|orbit| orbit.r);
    if (r - q).abs() >= SLOWER * (q - p).abs() || (r - q) * (q - p) <= 0.0 {
        return None;
    }
    let contacts = orbits[2].place.modes.len();
    let rest = |contact: usize| {
        let [x, y, z] = orbits.map(|orbit| slides(orbit, contact));
        if !(x > y && y > z && z > 0.0) {
            return None;
        }
        let mut urges = [(0.0, 0.0); 3];
        for (urge, orbit) in urges.iter_mut().zip(orbits) {
            *urge = (self::urge(family, orbit, contact)?, orbit.r);
        }
        let found = at_zero(urges);
        let [near, far] = found.lines;
        let falls = urges[2].0 < LESS * urges[0].0;
        let leads = (near - far).abs() <= APART * (near - r).abs() && (near - r) * (r - q) > 0.0;
        (falls && leads).then(|| Rest {
            contact,
            r: found.value,
            error: (found.value - near).abs(),
        })
    };
    (0..contacts).find_map(rest)
}

/// The mean acceleration with which a contact slides: it falls to zero as the force does that exceeds the limit, both where
/// that is a moment's, and where it lasts.
fn urge(family: &Family, orbit: &Orbit, contact: usize) -> Option<f64> {
    let flow = family.at(orbit.r).ok()?;
    let way = way(&*flow, (&orbit.place, orbit.period), contact).ok()?;
    let slides = slides(orbit, contact) * orbit.period;
    Some(way / slides.powi(2))
}

impl Rest {
    /// The point, and the orbits beyond; before it lie these two, as far as this way.
    fn passes(
        self,
        branch: &Branch<OrbitProblem>,
        orbits: [&Orbit; 2],
        way: f64,
        accuracy: f64,
    ) -> Option<Crossing<OrbitProblem, Orbit>> {
        let (last, settings) = (orbits[1], branch.settings());
        let search = near(last, accuracy);
        let family = &branch.problem.family;
        let (r, held) = BEYOND.into_iter().find_map(|far| {
            let r = beyond(self.r, far * way, &settings)?;
            Some((r, held(family, r, (orbits, self.contact), &search)?))
        })?;
        let started = begin(family, &held, &search, settings, (r, way > 0.0)).ok()?;
        let mut known = (started.1.z.clone(), started.1.r);
        let mut closer = |rest: Self, share| rest.sharper(&started, &mut known, share, accuracy);
        let seen = closer(self, 1.0)?;
        if (seen.r - self.r).abs() > APART * way.abs() {
            return None;
        }
        let mut rest = seen;
        for share in CLOSER {
            rest = closer(rest, share).unwrap_or(rest);
        }
        let kind = Kind::VanishingSegment;
        Some(passes(
            last,
            (kind, rest.r, rest.error),
            Some(started),
            accuracy,
        ))
    }

    /// The same from the other side, where it is known better: how near orbits that are held are to letting go.
    fn sharper(
        self,
        (branch, point): &Started<OrbitProblem>,
        (z, at): &mut (DVector<f64>, f64),
        closer: f64,
        accuracy: f64,
    ) -> Option<Self> {
        let mut spares = [(0.0, 0.0); 3];
        // Begun as another one began, an orbit that is held would slide.
        let ahead = point.way(&branch.problem.scale());
        let slope = ahead.rows(0, z.len()) / ahead[z.len()];
        for (spare, share) in spares.iter_mut().zip(NEARER) {
            let r = self.r + closer * share * (point.r - self.r);
            let mut problem = branch.problem.clone();
            let guess = &*z + &slope * (r - *at);
            let found = correct_at(&mut problem, guess, r, accuracy).ok()?;
            (*z, *at) = (found.z, r);
            let shot = &found.linearisation.extra;
            let flow = problem.family.at(r).ok()?;
            let all = shot.stretches();
            *spare = (
                spare_force(flow.as_ref(), &shot.start, &all, self.contact)?,
                r,
            );
        }
        let found = at_zero(spares);
        Some(Self {
            r: found.value,
            error: (found.value - found.lines[0]).abs(),
            ..self
        })
    }
}

/// The place so far beyond r, or nearer if that is out of the range; `None` if r is.
fn beyond(r: f64, way: f64, settings: &Settings) -> Option<f64> {
    let (from, to) = (settings.from, settings.to);
    let end = if (to - from) * way > 0.0 { to } else { from };
    let far = r + way;
    let within = if settings.contains(far) {
        far
    } else {
        f64::midpoint(r, end)
    };
    settings.contains(r).then_some(within)
}

/// The orbit at r to which these two lead, if friction holds the contact there all along.
fn held(
    family: &Family,
    r: f64,
    (orbits, contact): ([&Orbit; 2], usize),
    search: &Search,
) -> Option<Orbit> {
    let guess = orbits[1].guess();
    let flow = family.with_magnitude(&guess.magnitude).at(r).ok()?;
    let period = once(flow.as_ref(), &guess.place, guess.period)?;
    let at = |place| Guess {
        place,
        period,
        pins: Vec::new(),
        division: None,
        ..guess.clone()
    };
    let holds = |guess: Guess| {
        let found = converge(family, r, &guess, search).ok()?;
        let held = slides(&found, contact) == 0.0 && !found.pins.is_empty();
        (held && reaches(&found, period)).then_some(found)
    };
    let clings = clings(family, r, orbits, contact).map(at);
    let sticks = |lap: &Passage| keeps_mode(lap, contact);
    let settles = || settles(flow.as_ref(), &at(guess.place.clone()), sticks).map(at);
    clings.and_then(holds).or_else(|| settles().and_then(holds))
}

/// Where the motion is in the middle of the time for which a contact sticks longest, continued to r.
fn clings(family: &Family, r: f64, orbits: [&Orbit; 2], contact: usize) -> Option<Place> {
    let [before, last] = orbits;
    let mut begin = 0.0;
    let sticks = last.segments.iter().filter_map(|segment| {
        begin += segment.duration;
        let middle = begin - 0.5 * segment.duration;
        (segment.modes[contact] == Mode::Stick).then_some((segment.duration, middle))
    });
    let (_, middle) = sticks.max_by(|a, b| a.0.total_cmp(&b.0))?;
    let there = |orbit: &Orbit| {
        let time = middle * orbit.period / last.period;
        let flow = family.at(orbit.r).ok()?;
        let passage = flow.advance(&orbit.heading.start, time, Want::default());
        Some(passage.ok()?.end)
    };
    let (old, mut place) = (there(before)?, there(last)?);
    let ahead = (r - last.r) / (last.r - before.r);
    for (x, old) in place.state.iter_mut().zip(old.state) {
        *x += ahead * (*x - old);
    }
    Some(place)
}

/// Where the motion from a guess repeats, as long as each of the laps that are looked at may be one.
pub(super) fn settles(
    flow: &dyn Flow,
    guess: &Guess,
    may: impl Fn(&Passage) -> bool,
) -> Option<Place> {
    let mut place = flow.place(&guess.place.state).ok()?;
    for _ in 0..LOOKS {
        let settled = flow.advance(&place, SETTLES * guess.period, Want::default());
        place = settled.ok()?.end;
        place.state = flow.wrapped(place.state);
        let again = flow.advance(&place, guess.period, Want::EXTREMA).ok()?;
        if !may(&again) {
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
    Some(place)
}

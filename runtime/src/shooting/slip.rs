//! Where friction lets go of a contact that it held all along: the branch goes on among orbits along which it slides.
//!
//! Held where it bears as much the one way as the other, it lets go where the largest part of the most that it can bear is 1,
//! and both ways at once; beyond, it slides for moments, to and fro.

use super::begin::begin;
use super::converge::converge;
use super::grip::{near, once, passes, reaches, slides};
use super::guess::Guess;
use super::orbit::Orbit;
use super::problem::OrbitProblem;
use super::sought::Search;
use super::swing::{peaks, spare_force};
use crate::continuation::{Branch, Crossing, Kind, Watched};
use crate::flow::Want;
use crate::math::at_zero;
use crate::motion::Family;

/// By what share of the most that a contact can bear it is asked for more where sliding orbits are looked for.
const BEYOND: [f64; 3] = [1e-2, 1e-3, 1e-1];
/// Periods after which shooting begins: where sliding sets off what hardly moved before, most of that dies away first.
const LATER: [f64; 3] = [0.0, 4.0, 32.0];
/// Relative change of r by which orbits are apart from which a slope is taken.
const APART: f64 = 1e-4;

/// Where a contact begins to slide.
#[derive(Debug, Clone, Copy)]
struct Slip {
    contact: usize,
    r: f64,
    error: f64,
    /// dr over the change of the largest part of what it can bear.
    way: f64,
}

/// The point after the last of these orbits at which friction lets go, and the orbits beyond.
pub(super) fn lets_go(
    branch: &Branch<OrbitProblem>,
    orbits: &[Orbit],
    accuracy: f64,
) -> Option<Crossing<OrbitProblem, Orbit>> {
    let [first, second, last] = spread(orbits)?;
    let family = &branch.problem.family;
    let contacts = 0..last.place.modes.len();
    let slips = contacts.filter_map(|contact| slip(family, [first, second, last], contact));
    let slip = slips.min_by(|a, b| (a.r - last.r).abs().total_cmp(&(b.r - last.r).abs()))?;
    let search = near(last, accuracy);
    let settings = branch.settings();
    let places = BEYOND.iter().map(|share| slip.r + share * slip.way);
    let started = places.filter(|r| settings.contains(*r)).find_map(|r| {
        let sliding = sliding(family, r, (last, slip.contact), &search)?;
        begin(family, &sliding, &search, settings, (r, slip.way > 0.0)).ok()
    })?;
    let kind = Kind::VanishingSegment;
    Some(passes(
        last,
        (kind, slip.r, slip.error),
        Some(started),
        accuracy,
    ))
}

/// The last of these orbits, and two before that are not too near to it for slopes: a branch comes to its end in ever smaller
/// steps.
fn spread(orbits: &[Orbit]) -> Option<[&Orbit; 3]> {
    let (last, before) = orbits.split_last()?;
    let from = |far: f64| {
        let apart = |orbit: &&Orbit| (orbit.r - last.r).abs() >= far * last.r_size();
        before.iter().rev().find(apart)
    };
    let second = from(APART)?;
    let first = from(2.0 * (second.r - last.r).abs() / last.r_size())?;
    Some([first, second, last])
}

/// Where three orbits that follow each other say that a contact begins to slide, if it comes ever nearer to it.
fn slip(family: &Family, orbits: [&Orbit; 3], contact: usize) -> Option<Slip> {
    let mut spare = [(0.0, 0.0); 3];
    for (spare, orbit) in spare.iter_mut().zip(orbits) {
        let flow = family.at(orbit.r).ok()?;
        let held = spare_force(
            flow.as_ref(),
            &orbit.heading.start,
            &orbit.segments,
            contact,
        )?;
        *spare = (held, orbit.r);
    }
    let [(far, _), (middle, before), (near, last)] = spare;
    let found = at_zero(spare);
    let comes = far > middle && middle > near && (found.value - last).abs() < (last - before).abs();
    comes.then(|| Slip {
        contact,
        r: found.value,
        error: (found.value - found.lines[0]).abs(),
        way: (last - before) / (middle - near),
    })
}

/// The orbit at r near this one along which the contact slides.
fn sliding(
    family: &Family,
    r: f64,
    (from, contact): (&Orbit, usize),
    search: &Search,
) -> Option<Orbit> {
    let held = family.at(from.r).ok()?;
    let turns = peaks(held.as_ref(), &from.heading.start, from.period, contact).ok()?;
    let mut times = turns.map(|turn| turn.time);
    times.sort_by(f64::total_cmp);
    // Shooting begins where the contact sticks for longest: between its turns.
    let [between, around] = [times[1] - times[0], from.period - times[1] + times[0]];
    let time = match between > around {
        true => f64::midpoint(times[0], times[1]),
        false => (times[1] + 0.5 * around) % from.period,
    };
    let place = held
        .advance(&from.heading.start, time, Want::default())
        .ok()?
        .end;
    let flow = family.at(r).ok()?;
    let period = once(flow.as_ref(), &place, from.period)?;
    LATER.iter().find_map(|periods| {
        let passage = flow.advance(&place, periods * period, Want::default());
        let guess = Guess {
            period,
            place: passage.ok()?.end,
            pins: Vec::new(),
            division: None,
            ..from.guess()
        };
        let found = converge(family, r, &guess, search).ok()?;
        let slips = slides(&found, contact) > 0.0 && found.pins.len() < from.pins.len();
        (slips && reaches(&found, period)).then_some(found)
    })
}

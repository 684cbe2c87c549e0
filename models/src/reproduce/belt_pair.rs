//! Thesis section 3.3: two coupled masses on one belt.

use std::time::{Duration, Instant};

use stickslip::field::Kernel;
use stickslip::report::numerals::{decimals, duration};
use stickslip::report::{Axis, Coordinate, Manuscript, Panel, Section, traced};
use stickslip::study::parallel;

use super::ReproduceError;
use super::ask::{Cycle, Subject};
use super::copies::copy;
use crate::BeltPair;

/// All copies are of size 10ⁱ.
const EXPONENT: i32 = 5;
/// A motion in phase at v_dr = 0.14, from which the others in phase settle.
const IN_PHASE: [f64; 4] = [-0.5884, 0.0, -0.4552, -0.1503];
/// A motion out of phase at v_dr = 0.2.
const OUT_OF_PHASE: [f64; 4] = [0.2012, 0.0, 0.5205, 0.2];
/// A motion out of phase at v_dr = 0.35.
const FAST: [f64; 4] = [-0.02611, 0.0, 0.6785, 0.3067];

/// An orbit of the thesis.
#[derive(Clone, Copy)]
struct Asked {
    v_dr: f64,
    /// Crossings of the section in one period, according to the thesis.
    count: usize,
    start: [f64; 4],
}

const FIGURE_13: [Asked; 3] = [
    asked(0.08, 2, IN_PHASE),
    asked(0.14, 1, IN_PHASE),
    asked(0.15, 2, IN_PHASE),
];
const FIGURE_14: [Asked; 4] = [
    asked(0.127, 8, OUT_OF_PHASE),
    asked(0.14, 4, OUT_OF_PHASE),
    asked(0.2, 2, OUT_OF_PHASE),
    asked(0.35, 1, FAST),
];

const fn asked(v_dr: f64, count: usize, start: [f64; 4]) -> Asked {
    Asked { v_dr, count, start }
}

/// An orbit of the thesis, found.
struct Found {
    asked: Asked,
    cycle: Cycle,
    time: Duration,
}

/// The section on the belt pair.
pub(super) fn section() -> Result<Section, ReproduceError> {
    let all: Vec<Asked> = FIGURE_13.iter().chain(&FIGURE_14).copied().collect();
    let pair = Subject::new(BeltPair::v_dr);
    let find = |&asked: &Asked| {
        let clock = Instant::now();
        let cycle = pair.settled(copy(Kernel::Arctan, EXPONENT), asked.v_dr, &asked.start)?;
        let time = clock.elapsed();
        Ok(Found { asked, cycle, time })
    };
    let found = parallel(&all, find).into_iter();
    let found: Vec<Found> = found.collect::<Result<_, ReproduceError>>()?;
    let (in_phase, out_of_phase) = found.split_at(FIGURE_13.len());
    let manuscript = Manuscript::new(include_str!("belt_pair.md"))
        .sketch(include_str!("sketches/belt_pair.svg"))
        .panels("3.13", panels(in_phase, [-1.0, 1.5]))
        .panels("3.14", panels(out_of_phase, [-0.25, 1.25]))
        .rows("belt-pair", rows(&found));
    Ok(manuscript.section()?)
}

/// One panel for each orbit, all axes between the same `ends`.
fn panels(found: &[Found], ends: [f64; 2]) -> impl Iterator<Item = Panel> {
    let axis = move |label| Axis::new(label).from(ends[0], ends[1]);
    found.iter().map(move |one| {
        let plane = [0, 2].map(Coordinate::State);
        let (v_dr, count) = (one.asked.v_dr, one.cycle.orbit.period_count);
        Panel::new(axis("*X*_{1}"), axis("*X*_{2}"))
            .titled(format!("*V*_{{dr}} = {v_dr}, period {count}"))
            .curve(traced("", 0, &one.cycle.motion, plane))
    })
}

fn rows(found: &[Found]) -> impl Iterator<Item = Vec<String>> {
    found.iter().enumerate().map(|(i, one)| {
        let orbit = &one.cycle.orbit;
        let kind = match i < FIGURE_13.len() {
            true => "in phase",
            false => "out of phase",
        };
        let largest = orbit.floquet.multipliers.first();
        vec![
            one.asked.v_dr.to_string(),
            kind.to_owned(),
            one.asked.count.to_string(),
            orbit.period_count.to_string(),
            decimals(orbit.period, 5),
            decimals(1.0 / orbit.period, 6),
            decimals(orbit.max_abs[0], 5),
            decimals(largest.map_or(f64::NAN, |m| m.norm()), 4),
            orbit.floquet.stability.name().to_owned(),
            duration(one.time),
        ]
    })
}

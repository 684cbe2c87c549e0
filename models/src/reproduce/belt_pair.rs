//! Thesis section 3.3: two coupled masses on one belt.

use std::time::{Duration, Instant};

use stickslip::field::Kernel;
use stickslip::report::{Axis, Column, Curve, Figure, Panel, Section, Table};
use stickslip::study::parallel;

use super::ReproduceError;
use super::ask::{Cycle, Subject};
use super::copies::copy;
use super::words::{decimals, duration};
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
    Ok(Section::new("Two masses on a belt")
        .sketch(
            include_str!("sketches/belt_pair.svg"),
            "Two masses on one belt, each held by a spring, and coupled by a third (Fig. 3.12 of the thesis).",
        )
        .text(
            "Two masses stick and slip at different times, and the spring between them lets each feel the other. All \
             quantities are without dimension: *X*_{1} and *X*_{2} are the displacements, *V*_{dr} is the speed of the \
             belt; the coupling spring has *α* = 1.2 times the stiffness of the others, friction on the second mass has \
             *β* = 1.3 times the limit of that on the first, and weakens with speed as before, with *γ* = 3. All copies \
             have *ε* = 10^{5}.",
        )
        .text(
            "Several motions can be stable at the same speed: *in phase*, the masses moving together, or *out of phase*, \
             roughly against each other. A solution is of *period n* if *X*_{1}′ passes *n* times from negative to \
             positive before it repeats. Doubled periods come from *flip* bifurcations, where an orbit loses its \
             stability to one that goes around twice.",
        )
        .figure(plot(
            "3.13",
            "Solutions in phase",
            "The two displacements against each other: along the diagonal the masses move together. At *V*_{dr} = 0.08 \
             and 0.15 the loop closes only after two turns, at 0.14 after one.",
            in_phase,
            [-1.0, 1.5],
).columns(3))
        .figure(plot(
            "3.14",
            "Solutions out of phase",
            "Read from the last panel to the first, as the belt slows down: one loop, two, four and eight. Each time the \
             orbit has doubled its period.",
            out_of_phase,
            [-0.25, 1.25],
).columns(2))
        .table(table(&found))
        .text(
            "The equilibrium of the copies is printed in the thesis, (3.15), with the denominator 3.44 (1 + 3 *V*_{dr}); \
             it is 3.4 (1 + 3 *V*_{dr}), as in (3.14), for 1 + 2*α* = 3.4.",
        ))
}

/// One panel for each orbit, all axes between the same `ends`.
fn plot(number: &str, title: &str, caption: &str, found: &[Found], ends: [f64; 2]) -> Figure {
    let axis = |label| Axis::new(label).from(ends[0], ends[1]);
    found
        .iter()
        .fold(Figure::new(number, title, caption), |figure, one| {
            let path = one.cycle.path.iter().map(|state| [state[0], state[2]]);
            let panel = Panel::new(axis("*X*_{1}"), axis("*X*_{2}"))
                .titled(format!(
                    "*V*_{{dr}} = {}, period {}",
                    one.asked.v_dr, one.cycle.orbit.period_count
                ))
                .curve(Curve::line("", 0, path.collect()));
            figure.panel(panel)
        })
}

fn table(found: &[Found]) -> Table {
    let columns = [
        Column::numbers("*V*_{dr}"),
        Column::words("kind"),
        Column::numbers("period *n*, thesis"),
        Column::numbers("here"),
        Column::numbers("*T*"),
        Column::numbers("*f*"),
        Column::numbers("max |*X*_{1}|"),
        Column::numbers("largest |*λ*|"),
        Column::words("stability"),
        Column::numbers("time to find"),
    ];
    let caption = "The orbits of Figs. 3.13 and 3.14. The thesis draws them and names their kind, and prints no other \
                   numbers. Each was found by letting the motion settle from a known orbit at another speed, and by \
                   Newton's method from there. All its branches together took the thesis 9 h 35 \
                   min.";
    Table::new("belt-pair", caption, columns).rows(found.iter().enumerate().map(|(i, one)| {
        let orbit = &one.cycle.orbit;
        let largest = orbit.floquet.multipliers.first();
        vec![
            one.asked.v_dr.to_string(),
            if i < FIGURE_13.len() {
                "in phase"
            } else {
                "out of phase"
            }
            .to_owned(),
            one.asked.count.to_string(),
            orbit.period_count.to_string(),
            decimals(orbit.period, 5),
            decimals(1.0 / orbit.period, 6),
            decimals(orbit.max_abs[0], 5),
            decimals(largest.map_or(f64::NAN, |m| m.norm()), 4),
            orbit.floquet.stability.name().to_owned(),
            duration(one.time),
        ]
    }))
}

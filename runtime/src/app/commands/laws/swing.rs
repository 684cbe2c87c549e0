//! A law with internal state: the loops of its force as its contact swings, slowly and ten times as fast.

use serde_json::{Value, json};

use super::arguments::Wish;
use super::exhibit::{Exhibit, Known};
use crate::app::document::unit;
use crate::app::failure::{Failure, refuse};
use crate::app::spreadsheet::{Spreadsheet, full, head};
use crate::app::text::{line, number, table};
use crate::memory::MemoryLawInfo;
use crate::report::{self, Axis, Figure, Panel};
use crate::study::{Hysteresis, Remembering};

/// How much faster the second swing is: what it changes is the rate dependence of a law.
const FASTER: f64 = 10.0;
/// Digits shown of a force.
const DIGITS: usize = 6;

/// Displacement and force of one swing.
struct Loop {
    speed: f64,
    points: Vec<[f64; 2]>,
}

/// A law of the list as it is shown.
pub(super) fn swing(
    remembering: &Remembering,
    built: &dyn Hysteresis,
    values: &[f64],
    wish: &Wish,
) -> Result<Exhibit, Failure> {
    let amplitude = wish.amplitude.unwrap_or(remembering.amplitude);
    let slow = wish.speed.unwrap_or(remembering.speed);
    shown(built, (amplitude, slow), values, None, wish)
}

/// A law as it acts in a model: where it acts is its name, and how it is declared.
pub(super) fn acting(
    built: &dyn Hysteresis,
    place: (String, String),
    wish: &Wish,
) -> Result<Exhibit, Failure> {
    let amplitude = wish.amplitude.unwrap_or_else(|| built.yielding());
    let slow = wish.speed.unwrap_or(amplitude);
    shown(built, (amplitude, slow), &[], Some(place), wish)
}

fn shown(
    built: &dyn Hysteresis,
    (amplitude, slow): (f64, f64),
    values: &[f64],
    place: Option<(String, String)>,
    wish: &Wish,
) -> Result<Exhibit, Failure> {
    let law = built.law();
    if let Some(smoothing) = wish.smoothing {
        return refuse!(
            "`--smooth {smoothing}`: `{}` has internal state and no force that jumps; it is integrated as it is",
            law.name
        );
    }
    let mut loops = Vec::new();
    for speed in [slow, FASTER * slow] {
        let points = built.swing(amplitude, speed).map_err(|error| {
            Failure::failed(format!("`{}` cannot be followed: {error}", law.name))
        })?;
        loops.push(Loop { speed, points });
    }
    let known = Known {
        name: law.name,
        doc: law.doc,
        formulas: law.lines(),
        parameters: law.parameters,
        values,
    };
    let (name, place) = place.unzip();
    let name = name.unwrap_or_else(|| known.command());
    let mut document = document(&name, law, &known, amplitude, &loops);
    if let Some(place) = &place {
        document["contact"] = json!(place);
    }
    Ok(Exhibit {
        listing: known.listing(),
        text: known.text(&name, place.as_deref()) + &text(amplitude, &loops),
        document,
        figure: figure(&name, &loops),
        sheet: sheet(&loops),
        name,
    })
}

fn text(amplitude: f64, loops: &[Loop]) -> String {
    let shown = |value: f64| number(value, DIGITS);
    let mut lines = "speed (m/s)\tlargest force (N)\tforce at the turn (N)\n".to_owned();
    for one in loops {
        let forces = one.points.iter().map(|[_, force]| force.abs());
        let turn = one.points.last().map_or(f64::NAN, |[_, force]| *force);
        lines += &line([one.speed, forces.fold(0.0, f64::max), turn].map(shown));
    }
    let amplitude = shown(amplitude);
    format!("\nswinging by {amplitude} m to and fro\n{}", table(&lines))
}

fn document(
    name: &str,
    law: &MemoryLawInfo,
    known: &Known<'_>,
    amplitude: f64,
    loops: &[Loop],
) -> Value {
    let states = law.states.iter().map(|state| {
        json!({ "name": state.name, "doc": state.doc.trim(),
                "unit": unit(state.unit), "equation": state.equation,
                "stop": state.stop.map(|stop| stop.bound) })
    });
    let column = |one: &Loop, i: usize| one.points.iter().map(|point| point[i]).collect::<Vec<_>>();
    let loops = loops.iter().map(|one| {
        json!({ "speed": one.speed, "displacement": column(one, 0), "force": column(one, 1) })
    });
    json!({
        "law": name, "name": law.name, "doc": law.doc.trim(), "force": law.force,
        "states": states.collect::<Vec<_>>(), "parameters": known.parameters(),
        "values": known.values(), "amplitude": amplitude,
        "units": { "amplitude": "m", "speed": "m/s", "displacement": "m", "force": "N" },
        "loops": loops.collect::<Vec<_>>(),
    })
}

fn figure(name: &str, loops: &[Loop]) -> Figure {
    let panel = Panel::new(
        Axis::new("displacement (m)"),
        Axis::new("friction force opposing it (N)"),
    );
    let curves = loops.iter().enumerate().map(|(series, one)| {
        let label = format!("at {} m/s", number(one.speed, 2));
        report::Curve::line(label, series, one.points.clone())
    });
    Figure::new("law", name, "").panel(panel.curves(curves))
}

fn sheet(loops: &[Loop]) -> Spreadsheet {
    let rows = loops.iter().flat_map(|one| {
        let row = |[place, force]: &[f64; 2]| vec![full(&one.speed), full(place), full(force)];
        one.points.iter().map(row)
    });
    Spreadsheet::new(head(["speed (m/s)", "displacement (m)", "force (N)"]), rows)
}

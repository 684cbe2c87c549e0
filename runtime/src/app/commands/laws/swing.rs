//! A law with internal state: the loops of its force as its contact swings, slowly and ten times as fast.

use serde_json::{Value, json};

use super::exhibit::{Computed, Exhibit, Known, Place, Wish};
use crate::app::document::unit;
use crate::app::failure::{Failure, refuse};
use crate::app::spreadsheet::{Columns, Spreadsheet};
use crate::app::text::{line, number, table};
use crate::report::{Axis, Curve, Panel};
use crate::study::Hysteresis;

/// How much faster the second swing is: what it changes is the rate dependence of a law.
const FASTER: f64 = 10.0;
/// Digits shown of a force.
const DIGITS: usize = 6;

/// Displacement and force of one swing.
struct Loop {
    speed: f64,
    points: Vec<[f64; 2]>,
}

/// The law as it is shown, alone or where it acts.
pub(super) fn swing(
    built: &dyn Hysteresis,
    place: Option<Place>,
    values: &[f64],
    wish: &Wish,
) -> Result<Exhibit, Failure> {
    let law = built.law();
    if let Some(smoothing) = wish.smoothing {
        return refuse!(
            "`--smooth {smoothing}`: `{}` has internal state and no force that jumps; it is integrated as it is",
            law.name
        );
    }
    let usual = built.usual();
    let amplitude = wish.amplitude.or(usual.map(|[amplitude, _]| amplitude));
    let amplitude = amplitude.unwrap_or_else(|| built.yielding());
    let slow = wish.speed.or(usual.map(|[_, speed]| speed));
    let slow = slow.unwrap_or(amplitude);
    let mut loops = Vec::new();
    for speed in [slow, FASTER * slow] {
        let points = built.swing(amplitude, speed).map_err(|error| {
            Failure::failed(format!("`{}` cannot be followed: {error}", law.name))
        })?;
        loops.push(Loop { speed, points });
    }
    let states = law.states.iter().map(|state| {
        json!({ "name": state.name, "doc": state.doc.trim(),
                "unit": unit(state.unit), "equation": state.equation,
                "stop": state.stop.map(|stop| stop.bound) })
    });
    let mut fields_of_law = json!({ "force": law.force, "states": states.collect::<Vec<_>>() });
    if let Some((_, declared)) = &place {
        fields_of_law["contact"] = json!(declared);
    }
    let known = Known {
        name: law.name,
        doc: law.doc,
        formulas: law.lines(),
        fields: fields_of_law,
        parameters: law.parameters,
        values,
    };
    let found = Computed {
        text: text(amplitude, &loops),
        fields: fields(amplitude, &loops),
        panel: panel(&loops),
        sheet: sheet(&loops),
    };
    Ok(known.exhibit(place, found))
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

fn fields(amplitude: f64, loops: &[Loop]) -> Value {
    let column = |one: &Loop, i: usize| one.points.iter().map(|point| point[i]).collect::<Vec<_>>();
    let loops = loops.iter().map(|one| {
        json!({ "speed": one.speed, "displacement": column(one, 0), "force": column(one, 1) })
    });
    json!({
        "amplitude": amplitude,
        "units": { "amplitude": "m", "speed": "m/s", "displacement": "m", "force": "N" },
        "loops": loops.collect::<Vec<_>>(),
    })
}

fn panel(loops: &[Loop]) -> Panel {
    let curves = loops.iter().enumerate().map(|(series, one)| {
        let label = format!("at {} m/s", number(one.speed, 2));
        Curve::line(label, series, one.points.clone())
    });
    let [x, y] = ["displacement (m)", "friction force opposing it (N)"].map(Axis::new);
    Panel::new(x, y).curves(curves)
}

fn sheet(loops: &[Loop]) -> Spreadsheet {
    let heads = ["speed (m/s)", "displacement (m)", "force (N)"].map(str::to_owned);
    let columns = Columns::new().numbers(heads, |row: &[f64; 3], j| Some(row[j]));
    let rows = loops.iter().flat_map(|one| {
        let points = one.points.iter();
        points.map(|[place, force]| [one.speed, *place, *force])
    });
    columns.sheet(&rows.collect::<Vec<_>>())
}

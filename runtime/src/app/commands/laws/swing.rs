//! The loops of the force of a law with internal state as its contact swings, or of a press as it strikes, slowly and ten
//! times as fast.

use serde_json::{Value, json};

use super::exhibit::{Computed, Exhibit, Known, Place, Wish};
use crate::app::document::unit;
use crate::app::failure::{Failure, refuse};
use crate::app::spreadsheet::{Columns, Spreadsheet};
use crate::app::text::{line, number, table};
use crate::report::{Axis, Curve, Panel};
use crate::study::{Hysteresis, Strike};

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
    let swings = Swings {
        amplitude,
        loops,
        title: "swinging by {} m to and fro",
        turn: "force at the turn (N)",
        axes: ["displacement (m)", "friction force opposing it (N)"],
    };
    Ok(known.exhibit(place, swings.computed()))
}

/// A law of presses as it is shown, alone or where it acts; `depth` is that of a strike if nothing else is said.
pub(super) fn strike(
    built: &dyn Strike,
    place: Option<Place>,
    values: &[f64],
    wish: &Wish,
    depth: f64,
) -> Result<Exhibit, Failure> {
    let law = built.law();
    if let Some(smoothing) = wish.smoothing {
        return refuse!(
            "`--smooth {smoothing}`: `{}` presses and lets go; copies are shown of laws of friction",
            law.name
        );
    }
    let usual = built.usual();
    let amplitude = wish.amplitude.or(usual.map(|[depth, _]| depth));
    let amplitude = amplitude.unwrap_or(depth);
    let slow = wish.speed.or(usual.map(|[_, speed]| speed));
    let slow = slow.unwrap_or(amplitude);
    let loops = [slow, FASTER * slow].map(|speed| Loop {
        speed,
        points: built.strike(amplitude, speed),
    });
    let mut fields = json!({ "formula": law.lines().pop() });
    if let Some((_, declared)) = &place {
        fields["contact"] = json!(declared);
    }
    let known = Known {
        name: law.name,
        doc: law.doc,
        formulas: law.lines(),
        fields,
        parameters: law.parameters,
        values,
    };
    let swings = Swings {
        amplitude,
        loops: loops.into(),
        title: "striking to the depth of {} m",
        turn: "force at the end (N)",
        axes: ["depth (m)", "force (N)"],
    };
    Ok(known.exhibit(place, swings.computed()))
}

/// Loops and how they are told of.
struct Swings {
    amplitude: f64,
    loops: Vec<Loop>,
    /// The line above them, with a place for the amplitude.
    title: &'static str,
    /// The head of the column with the last force.
    turn: &'static str,
    axes: [&'static str; 2],
}

impl Swings {
    fn computed(&self) -> Computed {
        Computed {
            text: self.text(),
            fields: fields(self.amplitude, &self.loops),
            panel: self.panel(),
            sheet: sheet(&self.loops),
        }
    }

    fn text(&self) -> String {
        let shown = |value: f64| number(value, DIGITS);
        let mut lines = format!("speed (m/s)\tlargest force (N)\t{}\n", self.turn);
        for one in &self.loops {
            let forces = one.points.iter().map(|[_, force]| force.abs());
            let turn = one.points.last().map_or(f64::NAN, |[_, force]| *force);
            lines += &line([one.speed, forces.fold(0.0, f64::max), turn].map(shown));
        }
        let title = self.title.replace("{}", &shown(self.amplitude));
        format!("\n{title}\n{}", table(&lines))
    }

    fn panel(&self) -> Panel {
        let curves = self.loops.iter().enumerate().map(|(series, one)| {
            let label = format!("at {} m/s", number(one.speed, 2));
            Curve::line(label, series, one.points.clone())
        });
        let [x, y] = self.axes.map(Axis::new);
        Panel::new(x, y).curves(curves)
    }
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

fn sheet(loops: &[Loop]) -> Spreadsheet {
    let heads = ["speed (m/s)", "displacement (m)", "force (N)"].map(str::to_owned);
    let columns = Columns::new().numbers(heads, |row: &[f64; 3], j| Some(row[j]));
    let rows = loops.iter().flat_map(|one| {
        let points = one.points.iter();
        points.map(|[place, force]| [one.speed, *place, *force])
    });
    columns.sheet(&rows.collect::<Vec<_>>())
}

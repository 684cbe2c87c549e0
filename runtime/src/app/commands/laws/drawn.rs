//! A law without internal state: its force against the relative speed.

use serde_json::{Value, json};

use super::curve::{Curve, Sample, with_unit};
use super::exhibit::{Computed, Exhibit, Known, Place};
use crate::app::text::{line, number, table};
use crate::friction::LawInfo;
use crate::report::{self, Axis, Panel};

/// Digits shown of a force.
const DIGITS: usize = 6;

/// A law with its curve; `values` are those of its parameters, where they are given and not computed.
pub(super) fn drawn(
    law: &'static LawInfo,
    place: Option<Place>,
    values: &[f64],
    curve: &Curve,
) -> Exhibit {
    let known = Known {
        name: law.name,
        doc: law.doc,
        formulas: vec![
            format!("stick = {}", law.stick),
            format!("slip(s) = {}", law.slip),
        ],
        fields: json!({ "contact": place.as_ref().map(|(_, place)| place), "stick": law.stick, "slip": law.slip }),
        parameters: law.parameters,
        values,
    };
    let found = Computed {
        text: "\nforce against speed\n".to_owned() + &table(&rows(curve)),
        fields: fields(curve),
        panel: panel(law.name, curve),
        sheet: curve.sheet(),
    };
    known.exhibit(place, found)
}

fn fields(curve: &Curve) -> Value {
    let samples = &curve.samples;
    let column = |of: fn(&Sample) -> Option<f64>| samples.iter().map(of).collect::<Vec<_>>();
    let stated = |unit: &'static str| Some(unit).filter(|unit| !unit.is_empty());
    let [speed, force] = curve.units.map(stated);
    let [rest, sliding] = curve.limits;
    json!({
        "limit_at_rest": rest, "limit_of_sliding": sliding,
        "smoothing": curve.smoothing.map(|smoothing| smoothing.to_string()),
        "units": { "speed": speed, "force": force, "copy": force },
        "curve": {
            "speed": column(|sample| Some(sample.speed)),
            "force": column(|sample| Some(sample.force)),
            "copy": column(|sample| sample.copy),
        },
    })
}

/// Force against relative speed, the copy behind.
fn panel(name: &str, curve: &Curve) -> Panel {
    let [speed, force] = curve.units;
    let samples = curve.samples.iter();
    let copy = curve.smoothing.map(|smoothing| {
        let copies = samples.clone();
        let points = copies.filter_map(|sample| Some([sample.speed, sample.copy?]));
        report::Curve::line(smoothing.to_string(), 1, points.collect())
    });
    let exact = samples.map(|sample| [sample.speed, sample.force]);
    let axes = Panel::new(
        Axis::new(&with_unit("relative speed", speed)).from(-curve.speed, curve.speed),
        Axis::new(&with_unit("friction force opposing it", force)),
    );
    axes.curves(copy)
        .curve(report::Curve::line(name, 0, exact.collect()))
}

fn rows(curve: &Curve) -> String {
    let at_rest = number(curve.limits[0], DIGITS);
    let mut lines = line(curve.heads()) + &format!("at rest\tup to {at_rest}\n");
    for sample in curve.shown() {
        let numbers = [Some(sample.speed), Some(sample.force), sample.copy];
        let shown = numbers.into_iter().flatten();
        lines += &line(shown.map(|value| number(value, DIGITS)));
    }
    lines
}

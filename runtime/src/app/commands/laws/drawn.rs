//! A law without internal state: its force against the relative speed.

use serde_json::{Value, json};

use super::curve::{Curve, Sample, with_unit};
use super::exhibit::{Exhibit, Known};
use crate::app::text::{line, number, table};
use crate::friction::LawInfo;
use crate::report::{self, Axis, Figure, Panel};

/// Digits shown of a force.
const DIGITS: usize = 6;

/// What is drawn: a law and its curve.
pub(super) struct Drawn<'a> {
    pub(super) law: &'static LawInfo,
    /// Where it acts: its name, and how it is declared.
    pub(super) place: Option<(String, String)>,
    /// Values of the law's parameters, where they are given and not computed.
    pub(super) values: &'a [f64],
    pub(super) curve: Curve,
}

impl Drawn<'_> {
    pub(super) fn exhibit(&self) -> Exhibit {
        let law = self.law;
        let known = Known {
            name: law.name,
            doc: law.doc,
            formulas: vec![
                format!("stick = {}", law.stick),
                format!("slip(s) = {}", law.slip),
            ],
            parameters: law.parameters,
            values: self.values,
        };
        let name = match &self.place {
            Some((name, _)) => name.clone(),
            None => known.command(),
        };
        let place = self.place.as_ref().map(|(_, place)| place.as_str());
        let curve = table(&rows(&self.curve));
        Exhibit {
            listing: known.listing(),
            text: known.text(&name, place) + "\nforce against speed\n" + &curve,
            document: self.document(&name, place, &known),
            figure: self.figure(&name),
            sheet: self.curve.sheet(),
            name,
        }
    }

    fn document(&self, name: &str, place: Option<&str>, known: &Known<'_>) -> Value {
        let (law, curve) = (self.law, &self.curve);
        let samples = &curve.samples;
        let column = |of: fn(&Sample) -> Option<f64>| samples.iter().map(of).collect::<Vec<_>>();
        let stated = |unit: &'static str| Some(unit).filter(|unit| !unit.is_empty());
        let [speed, force] = curve.units.map(stated);
        json!({
            "law": name, "name": law.name, "doc": law.doc.trim(), "contact": place,
            "stick": law.stick, "slip": law.slip,
            "parameters": known.parameters(), "values": known.values(),
            "limit_at_rest": curve.limits[0], "limit_of_sliding": curve.limits[1],
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
    fn figure(&self, name: &str) -> Figure {
        let curve = &self.curve;
        let [speed, force] = curve.units;
        let points = |of: fn(&Sample) -> Option<f64>| {
            let samples = curve.samples.iter();
            samples
                .filter_map(|sample| Some([sample.speed, of(sample)?]))
                .collect::<Vec<_>>()
        };
        let copy = curve.smoothing.map(|smoothing| {
            let points = points(|sample| sample.copy);
            report::Curve::line(smoothing.to_string(), 1, points)
        });
        let exact = report::Curve::line(self.law.name, 0, points(|sample| Some(sample.force)));
        let panel = Panel::new(
            Axis::new(&with_unit("relative speed", speed)).from(-curve.speed, curve.speed),
            Axis::new(&with_unit("friction force opposing it", force)),
        );
        Figure::new("law", name, "").panel(panel.curves(copy).curve(exact))
    }
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

//! A law as JSON.

use serde_json::{Value, json};

use super::exhibit::Drawn;
use crate::app::document::{named, unit};
use crate::friction::LawParameter;

impl Drawn {
    pub(super) fn document(&self) -> Value {
        let (law, curve) = (self.law, &self.curve);
        let column = |of: fn(&super::curve::Sample) -> Value| {
            curve.samples.iter().map(of).collect::<Vec<_>>()
        };
        let [speed, force] = curve
            .units
            .map(|unit| Some(unit).filter(|unit| !unit.is_empty()));
        json!({
            "law": self.name, "name": law.name, "doc": law.doc.trim(), "contact": self.place,
            "stick": law.stick, "slip": law.slip,
            "parameters": parameters(law.parameters), "values": values(law.parameters, &self.values),
            "limit_at_rest": curve.at_rest, "limit_of_sliding": curve.at_start,
            "smoothing": curve.smoothing.map(|smoothing| smoothing.to_string()),
            "units": { "speed": speed, "force": force, "copy": force },
            "curve": {
                "speed": column(|sample| json!(sample.speed)),
                "force": column(|sample| json!(sample.force)),
                "copy": column(|sample| json!(sample.copy)),
            },
        })
    }
}

/// The parameters of a law.
pub(super) fn parameters(all: &[LawParameter]) -> Vec<Value> {
    let parameter = |declared: &LawParameter| {
        json!({ "name": declared.name, "doc": declared.doc.trim(), "unit": unit(declared.unit),
                "bounds": declared.bounds.describe(declared.name) })
    };
    all.iter().map(parameter).collect()
}

/// The values of the parameters of a law.
pub(super) fn values(parameters: &[LawParameter], values: &[f64]) -> Value {
    named(parameters.iter().map(|declared| declared.name), values)
}

//! A law as JSON.

use serde_json::{Map, Value, json};

use super::Drawn;

impl Drawn {
    pub(super) fn document(&self) -> Value {
        let (law, curve) = (self.law, &self.curve);
        let parameters = law.parameters.iter().map(|declared| {
            json!({ "name": declared.name, "doc": declared.doc.trim(),
                    "unit": declared.unit.map(|unit| unit.text),
                    "bounds": declared.bounds.describe(declared.name) })
        });
        let names = law
            .parameters
            .iter()
            .map(|declared| declared.name.to_owned());
        let values: Map<String, Value> = names
            .zip(self.values.iter().map(|value| json!(value)))
            .collect();
        let column = |of: fn(&super::curve::Sample) -> Value| {
            curve.samples.iter().map(of).collect::<Vec<_>>()
        };
        let [speed, force] = curve
            .units
            .map(|unit| Some(unit).filter(|unit| !unit.is_empty()));
        json!({
            "law": self.name, "name": law.name, "doc": law.doc.trim(), "contact": self.place,
            "stick": law.stick, "slip": law.slip,
            "parameters": parameters.collect::<Vec<_>>(), "values": values,
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

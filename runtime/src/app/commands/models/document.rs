//! A model as JSON.

use serde_json::{Value, json};

use crate::app::document::unit;
use crate::model::{Bound, Memory, ModelInfo};

pub(super) fn document(info: &ModelInfo) -> Value {
    let end = |bound: Option<Bound>| {
        bound.map(|bound| json!({ "value": bound.value, "inclusive": bound.inclusive }))
    };
    let states = info.states.iter().map(|state| {
        json!({ "name": state.name, "doc": state.doc.trim(), "unit": unit(state.unit),
                "start": state.start, "equation": state.equation })
    });
    let parameters = info.parameters.iter().map(|declared| {
        json!({ "name": declared.name, "doc": declared.doc.trim(), "unit": unit(declared.unit),
                "default": declared.default, "bounds": declared.bounds.describe(declared.name),
                "lower": end(declared.bounds.lower), "upper": end(declared.bounds.upper) })
    });
    let observables = info.observables.iter().map(|line| {
        json!({ "name": line.name, "doc": line.doc.trim(), "unit": unit(line.unit),
                               "formula": line.formula })
    });
    let contacts = info.contacts.iter().map(|contact| {
        json!({ "name": contact.name, "doc": contact.doc.trim(), "unit": unit(contact.unit),
                "law": contact.law.name, "fields": contact.fields, "speed": contact.speed, "speed_unit": unit(contact.speed_unit),
                "stick": contact.law.stick, "slip": contact.law.slip })
    });
    let memories = info.memories.iter().map(|memory| {
        let law = memory.law;
        let states = law.states.iter().map(|state| json!({ "name": state.name, "equation": state.equation,
                "stop": state.stop.map(|stop| stop.bound) }));
        let lets = law.abbreviations.iter().map(|(name, formula)| json!({ "name": name, "formula": formula }));
        json!({ "name": memory.name, "doc": memory.doc.trim(), "unit": unit(memory.unit),
                "law": law.name, "fields": memory.fields, "speed": memory.speed,
                "with": carriers(info, memory).collect::<Vec<_>>(), "states": states.collect::<Vec<_>>(),
                "lets": lets.collect::<Vec<_>>(), "force": law.force })
    });
    json!({
        "model": info.command, "name": info.name, "doc": info.doc.trim(),
        "states": states.collect::<Vec<_>>(), "parameters": parameters.collect::<Vec<_>>(),
        "observables": observables.collect::<Vec<_>>(), "contacts": contacts.collect::<Vec<_>>(),
        "memories": memories.collect::<Vec<_>>(),
    })
}

/// The states that carry the internal states of a law.
pub(super) fn carriers<'a>(
    info: &'a ModelInfo,
    memory: &'a Memory,
) -> impl Iterator<Item = &'a str> {
    let states = memory
        .states
        .iter()
        .filter_map(|&state| info.states.get(state));
    states.map(|state| state.name)
}

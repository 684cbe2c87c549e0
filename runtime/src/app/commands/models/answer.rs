//! Models as text and as JSON.

use serde_json::{Value, json};

use crate::app::document::unit;
use crate::app::text::{assigned, indented, label, summary, table};
use crate::model::{Bound, Contact, Memory, ModelInfo, Press};

/// A model in a list.
pub(super) fn brief(info: &ModelInfo) -> String {
    let named = |name: &str, law: &str| format!("{name} ({law})");
    let contacts = info.contacts.iter();
    let contacts = contacts.map(|contact| named(contact.name, contact.law.name));
    let memories = info.memories.iter();
    let friction = contacts.chain(memories.map(|line| named(line.name, line.law.name)));
    let mut lines = format!(
        "states\t{}\nparameters\t{}\nfriction\t{}\n",
        names(info.states.iter().map(|state| state.name.to_owned())),
        names(info.parameters.iter().map(|one| one.name.to_owned())),
        names(friction),
    );
    if !info.presses.is_empty() {
        let presses = info.presses.iter();
        let presses = presses.map(|press| named(press.name, press.law.name));
        lines += &format!("presses\t{}\n", names(presses));
    }
    let (name, summary) = (info.command, summary(info.doc));
    format!("{name}\n  {summary}\n{}", table(&lines))
}

fn names(names: impl Iterator<Item = String>) -> String {
    let names: Vec<String> = names.collect();
    if names.is_empty() {
        "-".to_owned()
    } else {
        names.join(", ")
    }
}

/// All that is declared of a model.
pub(super) fn describe(info: &ModelInfo) -> String {
    let states = info.states.iter().map(|state| {
        let value = assigned(state.name, state.start, state.unit);
        format!("{value}\t{}\n", summary(state.doc))
    });
    let parameters = info.parameters.iter().map(|one| {
        let value = assigned(one.name, one.default, one.unit);
        let bounds = one.bounds.describe(one.name);
        format!("{value}\t{bounds}\t{}\n", summary(one.doc))
    });
    let contacts = info.contacts.iter().map(contact);
    let memories = info.memories.iter().map(|line| memory(info, line));
    let presses = info.presses.iter().map(press);
    let observables = info.observables.iter().map(|line| {
        let name = label(line.name, line.unit);
        format!("{name} = {}\t{}\n", line.formula, summary(line.doc))
    });
    let equations = info.states.iter();
    let equations = equations.map(|state| format!("der({}) = {}\n", state.name, state.equation));
    let sections = [
        ("states", states.collect::<String>()),
        ("parameters", parameters.collect()),
        ("friction", contacts.chain(memories).collect()),
        ("presses", presses.collect()),
        ("observables", observables.collect()),
        ("equations", equations.collect()),
    ];
    let there = sections.iter().filter(|(_, lines)| !lines.is_empty());
    let told: String = there
        .map(|(title, lines)| format!("\n{title}\n{}", table(lines)))
        .collect();
    format!("{}\n{}{told}", info.command, indented(info.doc))
}

fn contact(contact: &Contact) -> String {
    let (law, name) = (contact.law, label(contact.name, contact.unit));
    format!(
        "{name}\t{} {{ {} }} opposing {}\t{}\n\tstick = {}; slip(s) = {}\t{}\n",
        law.name,
        contact.fields,
        contact.speed,
        summary(contact.doc),
        law.stick,
        law.slip,
        summary(law.doc),
    )
}

fn press(press: &Press) -> String {
    let (law, name) = (press.law, label(press.name, press.unit));
    format!(
        "{name}\t{} {{ {} }} closing {}\t{}\n\t{}\t{}\n",
        law.name,
        press.fields,
        press.gap,
        summary(press.doc),
        law.lines().join("; "),
        summary(law.doc),
    )
}

fn memory(info: &ModelInfo, memory: &Memory) -> String {
    let (law, name) = (memory.law, label(memory.name, memory.unit));
    format!(
        "{name}\t{} {{ {} }} opposing {} with {}\t{}\n\t{}\t{}\n",
        law.name,
        memory.fields,
        memory.speed,
        names(carriers(info, memory).map(str::to_owned)),
        summary(memory.doc),
        law.lines().join("; "),
        summary(law.doc),
    )
}

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
    let presses = info.presses.iter().map(|press| {
        let law = press.law;
        json!({ "name": press.name, "doc": press.doc.trim(), "unit": unit(press.unit),
                "law": law.name, "fields": press.fields, "gap": press.gap, "gap_unit": unit(press.gap_unit),
                "force": law.lines() })
    });
    json!({
        "model": info.command, "name": info.name, "doc": info.doc.trim(),
        "states": states.collect::<Vec<_>>(), "parameters": parameters.collect::<Vec<_>>(),
        "observables": observables.collect::<Vec<_>>(), "contacts": contacts.collect::<Vec<_>>(),
        "memories": memories.collect::<Vec<_>>(), "presses": presses.collect::<Vec<_>>(),
    })
}

/// The states that carry the internal states of a law.
fn carriers<'a>(info: &'a ModelInfo, memory: &'a Memory) -> impl Iterator<Item = &'a str> {
    let states = memory
        .states
        .iter()
        .filter_map(|&state| info.states.get(state));
    states.map(|state| state.name)
}

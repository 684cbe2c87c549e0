//! Models as text.

use super::document::carriers;
use crate::app::text::{assigned, indented, label, summary, table};
use crate::model::{Contact, Memory, ModelInfo};

/// A model in a list.
pub(super) fn brief(info: &ModelInfo) -> String {
    let named = |name: &str, law: &str| format!("{name} ({law})");
    let contacts = info.contacts.iter();
    let contacts = contacts.map(|contact| named(contact.name, contact.law.name));
    let memories = info.memories.iter();
    let friction = contacts.chain(memories.map(|line| named(line.name, line.law.name)));
    let lines = format!(
        "states\t{}\nparameters\t{}\nfriction\t{}\n",
        names(info.states.iter().map(|state| state.name.to_owned())),
        names(info.parameters.iter().map(|one| one.name.to_owned())),
        names(friction),
    );
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

//! Models as text.

use super::carriers;
use crate::app::text::{indented, label, short, summary, table, unit};
use crate::model::{Contact, Memory, ModelInfo, Parameter, State};

fn names<'a>(names: impl Iterator<Item = &'a str>) -> String {
    let names: Vec<&str> = names.collect();
    if names.is_empty() {
        "-".to_owned()
    } else {
        names.join(", ")
    }
}

pub(super) fn brief(info: &ModelInfo) -> String {
    let row = |name: &str, value: String| vec![name.to_owned(), value];
    let contacts = info
        .contacts
        .iter()
        .map(|contact| format!("{} ({})", contact.name, contact.law.name));
    let memories = info
        .memories
        .iter()
        .map(|memory| format!("{} ({})", memory.name, memory.law.name));
    let contacts: Vec<String> = contacts.chain(memories).collect();
    let rows = [
        row("states", names(info.states.iter().map(|state| state.name))),
        row(
            "parameters",
            names(info.parameters.iter().map(|declared| declared.name)),
        ),
        row("friction", names(contacts.iter().map(String::as_str))),
    ];
    format!(
        "{}\n  {}\n{}",
        info.command,
        summary(info.doc),
        table(&rows)
    )
}

pub(super) fn describe(info: &ModelInfo) -> String {
    let mut text = format!("{}\n{}", info.command, indented(info.doc));
    let mut section = |title: &str, rows: Vec<Vec<String>>| {
        if !rows.is_empty() {
            text.push_str(&format!("\n{title}\n{}", table(&rows)));
        }
    };
    section("states", info.states.iter().map(state).collect());
    section(
        "parameters",
        info.parameters.iter().map(parameter).collect(),
    );
    let contacts = info.contacts.iter().flat_map(contact);
    let memories = info.memories.iter().flat_map(|line| memory(info, line));
    section("friction", contacts.chain(memories).collect());
    let observables = info.observables.iter();
    section(
        "observables",
        observables
            .map(|line| {
                vec![
                    format!("{} = {}", label(line.name, line.unit), line.formula),
                    summary(line.doc),
                ]
            })
            .collect(),
    );
    let equations = info.states.iter();
    section(
        "equations",
        equations
            .map(|state| vec![format!("der({}) = {}", state.name, state.equation)])
            .collect(),
    );
    text
}

fn state(state: &State) -> Vec<String> {
    vec![
        format!(
            "{} = {}{}",
            state.name,
            short(state.start),
            unit(state.unit)
        ),
        summary(state.doc),
    ]
}

fn parameter(declared: &Parameter) -> Vec<String> {
    vec![
        format!(
            "{} = {}{}",
            declared.name,
            short(declared.default),
            unit(declared.unit)
        ),
        declared.bounds.describe(declared.name),
        summary(declared.doc),
    ]
}

fn contact(contact: &Contact) -> [Vec<String>; 2] {
    let law = contact.law;
    [
        vec![
            label(contact.name, contact.unit),
            format!(
                "{} {{ {} }} opposing {}",
                law.name, contact.fields, contact.speed
            ),
            summary(contact.doc),
        ],
        vec![
            String::new(),
            format!("stick = {}; slip(s) = {}", law.stick, law.slip),
            summary(law.doc),
        ],
    ]
}

fn memory(info: &ModelInfo, memory: &Memory) -> Vec<Vec<String>> {
    let law = memory.law;
    let row = |left: String, formula: String, doc: &str| vec![left, formula, summary(doc)];
    let first = format!(
        "{} {{ {} }} opposing {} with {}",
        law.name,
        memory.fields,
        memory.speed,
        names(carriers(info, memory))
    );
    let mut rows = vec![row(label(memory.name, memory.unit), first, memory.doc)];
    rows.push(row(String::new(), law.lines().join("; "), law.doc));
    rows
}

//! `models`: what is declared.

use clap::ArgMatches;
use serde_json::{Value, json};

use super::App;
use super::failure::Failure;
use super::options::text;
use super::output::Output;
use super::spreadsheet::Spreadsheet;
use super::text::{indented, label, short, summary, table, unit};
use crate::model::{Bound, Contact, Memory, ModelInfo, Parameter, State};

/// A model has no tables.
const NO_SHEETS: [(&str, Spreadsheet); 0] = [];

pub(super) fn perform(app: &App, options: &ArgMatches) -> Result<(), Failure> {
    let output = Output::new(options)?;
    match text(options, "MODEL") {
        Some(name) => {
            let info = app.entry(name)?.info();
            output.deliver(name, &describe(info), &document(info), &NO_SHEETS)
        }
        None => {
            let infos = app.entries.iter().map(|entry| entry.info());
            let documents: Vec<Value> = infos.clone().map(document).collect();
            let text = infos.map(brief).collect::<Vec<_>>().join("\n");
            output.deliver("models", &text, &json!({ "models": documents }), &NO_SHEETS)
        }
    }
}

fn names<'a>(names: impl Iterator<Item = &'a str>) -> String {
    let names: Vec<&str> = names.collect();
    if names.is_empty() {
        "-".to_owned()
    } else {
        names.join(", ")
    }
}

fn brief(info: &ModelInfo) -> String {
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

fn describe(info: &ModelInfo) -> String {
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

/// The first paragraph of a documentation.
fn summary_of(doc: &str) -> String {
    doc.trim()
        .split("\n\n")
        .next()
        .unwrap_or_default()
        .replace('\n', " ")
}

fn memory(info: &ModelInfo, memory: &Memory) -> Vec<Vec<String>> {
    let law = memory.law;
    let row = |left: String, formula: String, doc: &str| vec![left, formula, summary_of(doc)];
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

/// The states that carry the internal states of a law.
fn carriers<'a>(info: &'a ModelInfo, memory: &'a Memory) -> impl Iterator<Item = &'a str> {
    let states = memory
        .states
        .iter()
        .filter_map(|&state| info.states.get(state));
    states.map(|state| state.name)
}

fn document(info: &ModelInfo) -> Value {
    let end = |bound: Option<Bound>| {
        bound.map(|bound| json!({ "value": bound.value, "inclusive": bound.inclusive }))
    };
    let states = info.states.iter().map(|state| {
        json!({ "name": state.name, "doc": state.doc.trim(), "unit": state.unit.map(|unit| unit.text),
                "start": state.start, "equation": state.equation })
    });
    let parameters = info.parameters.iter().map(|declared| {
        json!({ "name": declared.name, "doc": declared.doc.trim(), "unit": declared.unit.map(|unit| unit.text),
                "default": declared.default, "bounds": declared.bounds.describe(declared.name),
                "lower": end(declared.bounds.lower), "upper": end(declared.bounds.upper) })
    });
    let observables = info.observables.iter().map(|line| {
        json!({ "name": line.name, "doc": line.doc.trim(), "unit": line.unit.map(|unit| unit.text),
                               "formula": line.formula })
    });
    let contacts = info.contacts.iter().map(|contact| {
        json!({ "name": contact.name, "doc": contact.doc.trim(), "unit": contact.unit.map(|unit| unit.text),
                "law": contact.law.name, "fields": contact.fields, "speed": contact.speed, "speed_unit": contact.speed_unit.map(|unit| unit.text),
                "stick": contact.law.stick, "slip": contact.law.slip })
    });
    let memories = info.memories.iter().map(|memory| {
        let law = memory.law;
        let states = law.states.iter().map(|state| json!({ "name": state.name, "equation": state.equation,
                "stop": state.stop.map(|stop| stop.bound) }));
        let lets = law.abbreviations.iter().map(|(name, formula)| json!({ "name": name, "formula": formula }));
        json!({ "name": memory.name, "doc": memory.doc.trim(), "unit": memory.unit.map(|unit| unit.text),
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

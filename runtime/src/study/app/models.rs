//! `models`: what is declared.

use clap::ArgMatches;
use serde_json::{Value, json};

use super::App;
use super::failure::Failure;
use super::options::text;
use super::output::Output;
use super::text::{label, short, table, unit};
use crate::model::{Bound, Contact, ModelInfo, Parameter, State};

pub(super) fn perform(app: &App, options: &ArgMatches) -> Result<(), Failure> {
    let output = Output::new(options)?;
    match text(options, "MODEL") {
        Some(name) => {
            let info = app.entry(name)?.info();
            output.deliver(name, &describe(info), &document(info), &[])
        }
        None => {
            let infos = app.entries.iter().map(|entry| entry.info());
            let documents: Vec<Value> = infos.clone().map(document).collect();
            let text = infos.map(summary).collect::<Vec<_>>().join("\n");
            output.deliver("models", &text, &json!({ "models": documents }), &[])
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

fn summary(info: &ModelInfo) -> String {
    let row = |name: &str, value: String| vec![name.to_owned(), value];
    let contacts = info
        .contacts
        .iter()
        .map(|contact| format!("{} ({})", contact.name, contact.law.name));
    let contacts: Vec<String> = contacts.collect();
    let rows = [
        row("states", names(info.states.iter().map(|state| state.name))),
        row(
            "parameters",
            names(info.parameters.iter().map(|declared| declared.name)),
        ),
        row("friction", names(contacts.iter().map(String::as_str))),
    ];
    format!("{}\n  {}\n{}", info.command, info.doc.trim(), table(&rows))
}

fn describe(info: &ModelInfo) -> String {
    let mut text = format!("{}\n  {}\n", info.command, info.doc.trim());
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
    section("friction", info.contacts.iter().flat_map(contact).collect());
    let observables = info.observables.iter();
    section(
        "observables",
        observables
            .map(|line| {
                vec![
                    format!("{} = {}", line.name, line.formula),
                    line.doc.trim().to_owned(),
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
        state.doc.trim().to_owned(),
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
        declared.doc.trim().to_owned(),
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
            contact.doc.trim().to_owned(),
        ],
        vec![
            String::new(),
            format!("stick = {}; slip(s) = {}", law.stick, law.slip),
            law.doc.trim().to_owned(),
        ],
    ]
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
    let observables = info
        .observables
        .iter()
        .map(|line| json!({ "name": line.name, "doc": line.doc.trim(), "formula": line.formula }));
    let contacts = info.contacts.iter().map(|contact| {
        json!({ "name": contact.name, "doc": contact.doc.trim(), "unit": contact.unit.map(|unit| unit.text),
                "law": contact.law.name, "fields": contact.fields, "speed": contact.speed,
                "stick": contact.law.stick, "slip": contact.law.slip })
    });
    json!({
        "model": info.command, "name": info.name, "doc": info.doc.trim(),
        "states": states.collect::<Vec<_>>(), "parameters": parameters.collect::<Vec<_>>(),
        "observables": observables.collect::<Vec<_>>(), "contacts": contacts.collect::<Vec<_>>(),
    })
}

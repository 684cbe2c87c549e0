//! What `cargo doc` shows of a declaration: its equations, and its states with their units.
//!
//! The page has them as MathML; an editor, which would show its tags, has the lines as written.

use proc_macro2::TokenStream;
use quote::quote;

use super::doc::doc;
use super::{info, typeset};
use crate::check::{Contact, Memory, MemoryLaw, Model, State, StaticLaw, Step};

/// The attributes that follow a model's own documentation.
pub(super) fn of_model(model: &Model) -> TokenStream {
    let equations = typeset::aligned(equations(model));
    let (friction, states) = (friction(model), states(model));
    let page = format!("\n# Equations\n\n{equations}\n\n{friction}# States\n\n{states}");
    attributes(&page, &lines(model).join("\n"))
}

/// The attributes that follow a law's own documentation.
pub(super) fn of_law(law: &StaticLaw) -> TokenStream {
    let sliding = typeset::applied("slip", &typeset::name(law.speed));
    let (stick, slip) = (typeset::row(&law.stick), typeset::row(&law.slip));
    let formulas = [("<mi>stick</mi>".to_owned(), stick), (sliding, slip)];
    let lines = [
        format!("stick = {}", law.stick),
        format!("slip({}) = {}", law.speed, law.slip),
    ];
    formulas_and(formulas.to_vec(), &lines)
}

/// The same for a law with internal state.
pub(super) fn of_memory_law(law: &MemoryLaw) -> TokenStream {
    let lets = law.lets.iter();
    let lets = lets.map(|line| (typeset::name(line.name), typeset::row(line.formula)));
    let states = law.states.iter();
    let rates = states.map(|state| (typeset::derivative(state.name), typeset::row(state.written)));
    let stops = law.states.iter().filter_map(|state| {
        let most = format!(
            "<mi>max</mi><mo>|</mo>{}<mo>|</mo>",
            typeset::name(state.name)
        );
        Some((most, typeset::row(state.stop.as_ref()?.written)))
    });
    let force = typeset::applied("force", &typeset::name(law.speed));
    let formulas = lets
        .chain(rates)
        .chain(stops)
        .chain([(force, typeset::row(law.written))]);
    let lets = law.lets.iter();
    let mut lines: Vec<String> = lets
        .map(|line| format!("{} = {}", line.name, line.formula))
        .collect();
    let states = law.states.iter();
    lines.extend(states.map(|state| format!("der({}) = {}", state.name, state.written)));
    for state in &law.states {
        lines.extend(
            state
                .stop
                .as_ref()
                .map(|stop| format!("stop {} at {}", state.name, stop.written)),
        );
    }
    lines.push(format!("force({}) = {}", law.speed, law.written));
    formulas_and(formulas.collect(), &lines)
}

fn formulas_and(formulas: Vec<(String, String)>, lines: &[String]) -> TokenStream {
    let page = format!(
        "\n# Formulas\n\n{}\n",
        typeset::aligned(formulas.into_iter())
    );
    attributes(&page, &lines.join("\n"))
}

fn attributes(page: &str, lines: &str) -> TokenStream {
    let lines = format!("\n```text\n{lines}\n```");
    quote!(#[cfg_attr(doc, doc = #page)] #[cfg_attr(not(doc), doc = #lines)])
}

/// Both sides of every `let` line and every equation.
fn equations(model: &Model) -> impl Iterator<Item = (String, String)> {
    let lets = model.lets();
    let lets = lets.map(|line| (typeset::name(line.name), typeset::row(line.formula)));
    let rates = model.states.iter().map(|state| {
        let rate = match state.carries {
            Some(force) => format!(
                "<mtext>as the law of </mtext>{}<mtext> says</mtext>",
                typeset::name(force)
            ),
            None => typeset::row(&state.rate),
        };
        (typeset::derivative(state.name), rate)
    });
    lets.chain(rates)
}

/// One item for each contact.
fn friction(model: &Model) -> String {
    let memories = model.memories().map(|memory| &memory.contact);
    let items: Vec<String> = model.contacts().chain(memories).map(contact).collect();
    if items.is_empty() {
        return String::new();
    }
    format!("# Friction\n\n{}\n\n", items.join("\n"))
}

fn contact(contact: &Contact) -> String {
    let fields = contact.fields.iter().map(|field| {
        let (name, value) = (typeset::name(field.name), typeset::row(field.formula));
        format!("<math>{name}<mo>=</mo>{value}</math>")
    });
    let unit = contact
        .unit
        .as_ref()
        .map(|unit| format!(" in `{}`", unit.text));
    format!(
        "* <math>{}</math>{} is `{}` with {}, opposing {}",
        typeset::name(contact.name),
        unit.unwrap_or_default(),
        law(contact),
        fields.collect::<Vec<_>>().join(", "),
        typeset::inline(contact.speed),
    )
}

fn states(model: &Model) -> String {
    let rows = model.states.iter().map(row);
    let head = "| state | unit | start | |\n|---|---|---|---|\n";
    head.to_owned() + &rows.collect::<Vec<_>>().join("\n")
}

fn row(state: &State) -> String {
    let unit = state.unit.as_ref().map(|unit| format!("`{}`", unit.text));
    let doc = doc(state.docs).replace('|', "\\|");
    let first = doc
        .split("\n\n")
        .next()
        .unwrap_or_default()
        .replace('\n', " ");
    format!(
        "| `{}` | {} | {} | {first} |",
        state.name,
        unit.unwrap_or_default(),
        state.start
    )
}

/// The lines as written.
fn lines(model: &Model) -> Vec<String> {
    let steps = model.steps.iter().map(|step| match step {
        Step::Let(line) => format!("{} = {}", line.name, line.formula),
        Step::Contact(contact) | Step::Memory(Memory { contact, .. }) => format!(
            "{} = {} {{ {} }} opposing {}",
            contact.name,
            law(contact),
            info::fields(contact),
            contact.speed
        ),
    });
    let rates = model.states.iter();
    let rates = rates.map(|state| format!("der({}) = {}", state.name, info::equation(state)));
    steps.chain(rates).collect()
}

/// The last word of a law's path.
fn law(contact: &Contact) -> String {
    let last = contact.law.segments.last();
    last.map(|segment| segment.ident.to_string())
        .unwrap_or_default()
}

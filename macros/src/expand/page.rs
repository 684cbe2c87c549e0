//! What `cargo doc` shows of a declaration: its equations, and its states with their units.
//!
//! The page has them as MathML; an editor, which would show its tags, has the lines as written.

use proc_macro2::TokenStream;
use quote::quote;

use super::doc::doc;
use super::{info, typeset};
use crate::check::{Contact, Force, Law, LawState, Let, Model, State, Step};
use crate::formula::{Formula, last_word};

/// The attributes that follow a model's own documentation.
pub(super) fn of_model(model: &Model) -> TokenStream {
    let equations = typeset::aligned(equations(model));
    let friction = section("Friction", model.contacts().chain(model.memories()));
    let (presses, states) = (section("Presses", model.presses()), states(model));
    let page = format!("\n# Equations\n\n{equations}\n\n{friction}{presses}# States\n\n{states}");
    attributes(&page, &lines(model).join("\n"))
}

/// The attributes that follow a law's own documentation.
pub(super) fn of_law(law: &Law) -> TokenStream {
    let applied = |word: &str| typeset::applied(word, &typeset::name(law.speed));
    let speed = law.speed;
    let rows: Vec<Row> = match &law.force {
        Force::Static(stick, slip) => vec![
            Row::of("stick", "<mi>stick</mi>".to_owned(), &stick.formula),
            Row::of(&format!("slip({speed})"), applied("slip"), &slip.formula),
        ],
        Force::Memory(force) => {
            let force = Row::of(&format!("force({speed})"), applied("force"), force.written);
            let rows = lets(&law.lets).chain(law.states.iter().map(rate));
            let rows = rows.chain(law.states.iter().filter_map(stop));
            rows.chain([force]).collect()
        }
        Force::Rigid(rebound) => {
            let row = Row::of(
                &format!("rebound({speed})"),
                applied("rebound"),
                rebound.written,
            );
            lets(&law.lets).chain([row]).collect()
        }
        Force::Press(force) => {
            let rate = law.rate.unwrap_or(speed);
            let both = format!("{}<mo>,</mo>{}", typeset::name(speed), typeset::name(rate));
            let shown = typeset::applied("force", &both);
            let force = Row::of(&format!("force({speed}, {rate})"), shown, force.written);
            lets(&law.lets).chain([force]).collect()
        }
    };
    let (lines, sides): (Vec<_>, Vec<_>) =
        rows.into_iter().map(|row| (row.line, row.sides)).unzip();
    let sides = typeset::aligned(sides.into_iter());
    attributes(&format!("\n# Formulas\n\n{sides}\n"), &lines.join("\n"))
}

/// A line as written, and both sides of its formula for the page.
struct Row {
    line: String,
    sides: (String, String),
}

impl Row {
    fn of(left: &str, shown: String, right: &Formula) -> Self {
        Self {
            line: format!("{left} = {right}"),
            sides: (shown, typeset::row(right)),
        }
    }
}

fn lets<'a>(lets: impl IntoIterator<Item = &'a Let<'a>>) -> impl Iterator<Item = Row> {
    lets.into_iter().map(|Let { line, .. }| {
        let name = &line.name;
        Row::of(&name.to_string(), typeset::name(name), &line.formula)
    })
}

fn rate(state: &LawState) -> Row {
    let name = &state.line.name;
    let left = format!("der({name})");
    Row::of(&left, typeset::derivative(name), state.rate.written)
}

fn stop(state: &LawState) -> Option<Row> {
    let (name, bound) = (&state.line.name, state.stop.as_ref()?.written);
    let shown = typeset::name(name);
    let most = format!("<mi>max</mi><mo>|</mo>{shown}<mo>|</mo>");
    Some(Row {
        line: format!("stop {name} at {bound}"),
        sides: (most, typeset::row(bound)),
    })
}

fn attributes(page: &str, lines: &str) -> TokenStream {
    let lines = format!("\n```text\n{lines}\n```");
    quote!(#[cfg_attr(doc, doc = #page)] #[cfg_attr(not(doc), doc = #lines)])
}

/// Both sides of every `let` line and every equation.
fn equations(model: &Model) -> impl Iterator<Item = (String, String)> {
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
    lets(model.lets()).map(|row| row.sides).chain(rates)
}

/// One item for each contact.
fn section<'m>(title: &str, contacts: impl Iterator<Item = &'m Contact<'m>>) -> String {
    let items: Vec<String> = contacts.map(contact).collect();
    if items.is_empty() {
        return String::new();
    }
    format!("# {title}\n\n{}\n\n", items.join("\n"))
}

/// The word before the speed or the gap of a contact.
fn word(contact: &Contact) -> &'static str {
    if contact.is_press() {
        "closing"
    } else {
        "opposing"
    }
}

fn contact(contact: &Contact) -> String {
    let line = contact.line;
    let fields = line.fields.iter().map(|field| {
        let (name, value) = (typeset::name(&field.name), typeset::row(&field.formula));
        format!("<math>{name}<mo>=</mo>{value}</math>")
    });
    let unit = contact
        .unit
        .as_ref()
        .map(|unit| format!(" in `{}`", unit.text));
    format!(
        "* <math>{}</math>{} is `{}` with {}, {} {}",
        typeset::name(&line.name),
        unit.unwrap_or_default(),
        last_word(&line.law),
        fields.collect::<Vec<_>>().join(", "),
        word(contact),
        typeset::inline(&line.speed),
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
        Step::Let(Let { line, .. }) => format!("{} = {}", line.name, line.formula),
        Step::Contact(contact) => {
            let line = contact.line;
            let (law, fields) = (last_word(&line.law), info::fields(line));
            format!(
                "{} = {law} {{ {fields} }} {} {}",
                line.name,
                word(contact),
                line.speed
            )
        }
    });
    let rates = model.states.iter();
    let rates = rates.map(|state| format!("der({}) = {}", state.name, info::equation(state)));
    steps.chain(rates).collect()
}

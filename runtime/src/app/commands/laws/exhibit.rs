//! A law ready to be shown, of whatever kind.

use clap::Args;
use heck::ToKebabCase;
use serde_json::{Map, Value, json};

use crate::app::document::{named, unit};
use crate::app::failure::Failure;
use crate::app::spreadsheet::Spreadsheet;
use crate::app::text::{assigned, indented, summary, table};
use crate::app::values::Reading;
use crate::app::words::positive;
use crate::field::Smoothing;
use crate::friction::LawParameter;
use crate::report::{Figure, Panel};

/// What is said of the drawing.
#[derive(Debug, Clone, Args)]
pub(in crate::app) struct Wish {
    /// The copy beside it, for instance tanh:50
    #[arg(long = "smooth", value_name = "KERNEL:SIZE", value_parser = Reading(smoothing))]
    pub(super) smoothing: Option<Smoothing>,
    /// The largest sliding speed, or that of a swing
    #[arg(long, value_name = "V", value_parser = Reading(positive))]
    pub(super) speed: Option<f64>,
    /// Of a swing that shows what a law remembers
    #[arg(long, value_name = "X", value_parser = Reading(positive))]
    pub(super) amplitude: Option<f64>,
}

fn smoothing(option: &str, word: &str) -> Result<Smoothing, Failure> {
    word.parse()
        .map_err(|error| Failure::usage(format!("`{option} {word}`: {error}")))
}

/// A law as everything that the program writes.
pub(super) struct Exhibit {
    pub(super) name: String,
    /// A few lines, for a list.
    pub(super) listing: String,
    /// All that is known of it.
    pub(super) text: String,
    pub(super) document: Value,
    pub(super) figure: Figure,
    pub(super) sheet: Spreadsheet,
}

/// What is known of a law of either kind.
pub(super) struct Known<'a> {
    /// Its name as a type.
    pub(super) name: &'static str,
    pub(super) doc: &'static str,
    /// Its formulas, one a line, and as fields of the document.
    pub(super) formulas: Vec<String>,
    pub(super) fields: Value,
    pub(super) parameters: &'static [LawParameter],
    /// Values of its parameters, where they are given and not computed.
    pub(super) values: &'a [f64],
}

/// What is computed of a law of either kind.
pub(super) struct Computed {
    pub(super) text: String,
    /// More fields of the document.
    pub(super) fields: Value,
    pub(super) panel: Panel,
    pub(super) sheet: Spreadsheet,
}

/// Where a law acts: its name there, and how it is declared.
pub(super) type Place = (String, String);

impl Known<'_> {
    /// The law in all forms.
    pub(super) fn exhibit(&self, place: Option<Place>, found: Computed) -> Exhibit {
        let command = self.name.to_kebab_case();
        let (name, declared) = match place {
            Some((name, declared)) => (name, Some(declared)),
            None => (command.clone(), None),
        };
        let parts = [
            json!({ "law": name, "name": self.name, "doc": self.doc.trim() }),
            self.fields.clone(),
            json!({ "parameters": self.parameters(), "values": self.values() }),
            found.fields,
        ];
        let parts = parts.into_iter().flat_map(|part| match part {
            Value::Object(fields) => fields,
            _ => Map::new(),
        });
        Exhibit {
            listing: self.listing(&command),
            text: self.text(&name, declared.as_deref()) + &found.text,
            document: parts.collect(),
            figure: Figure::new("law", &name, "").panel(found.panel),
            sheet: found.sheet,
            name,
        }
    }

    /// A few lines, for a list.
    fn listing(&self, command: &str) -> String {
        let pairs = self.parameters.iter().zip(self.values);
        let values = pairs.map(|(one, &value)| assigned(one.name, value, one.unit));
        format!(
            "{command}\n  {}\n{}    {}\n",
            summary(self.doc),
            self.lines("    "),
            values.collect::<Vec<_>>().join(", ")
        )
    }

    /// Its formulas, where it acts, and its parameters, under this name.
    fn text(&self, name: &str, place: Option<&str>) -> String {
        let mut text = format!("{name}\n{}\nformulas\n", indented(self.doc)) + &self.lines("  ");
        if let Some(place) = place {
            text += &format!("\ncontact\n  {place}\n");
        }
        if !self.values.is_empty() {
            let pairs = self.parameters.iter().zip(self.values);
            let rows = pairs.map(|(one, &value)| {
                let value = assigned(one.name, value, one.unit);
                let bounds = one.bounds.describe(one.name);
                format!("{value}\t{bounds}\t{}\n", summary(one.doc))
            });
            text += &format!("\nparameters\n{}", table(&rows.collect::<String>()));
        }
        text
    }

    fn lines(&self, indent: &str) -> String {
        let lines = self.formulas.iter();
        lines.map(|line| format!("{indent}{line}\n")).collect()
    }

    /// Its parameters as JSON.
    fn parameters(&self) -> Vec<Value> {
        let parameter = |declared: &LawParameter| {
            json!({ "name": declared.name, "doc": declared.doc.trim(), "unit": unit(declared.unit),
                    "bounds": declared.bounds.describe(declared.name) })
        };
        self.parameters.iter().map(parameter).collect()
    }

    /// The values of its parameters as JSON.
    fn values(&self) -> Value {
        let names = self.parameters.iter().map(|declared| declared.name);
        named(names, self.values)
    }
}

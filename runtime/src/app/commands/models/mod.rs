//! `models`: what is declared.

mod arguments;
mod document;
mod text;

use serde_json::{Value, json};

use crate::app::failure::Failure;
use crate::app::offer::App;
use crate::app::output::Output;
use crate::app::spreadsheet::Spreadsheet;
pub(in crate::app) use arguments::Arguments;
use document::document;
use text::{brief, describe};

/// A model has no tables.
const NO_SHEETS: [(&str, Spreadsheet); 0] = [];

pub(in crate::app) fn perform(app: &App, arguments: &Arguments) -> Result<(), Failure> {
    let output = Output::from(&arguments.view);
    match &arguments.model {
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

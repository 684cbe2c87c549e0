//! `models`: what is declared.

mod answer;

use clap::Args;
use serde_json::{Value, json};

use crate::app::answer::Answer;
use crate::app::arguments::View;
use crate::app::failure::Failure;
use crate::app::offer::App;
use crate::app::output::Output;
use answer::{brief, describe, document};

/// Show the models, or all that is declared of one
#[derive(Debug, Clone, Args)]
pub(in crate::app) struct Arguments {
    /// Which one
    model: Option<String>,
    #[command(flatten)]
    view: View,
}

pub(in crate::app) fn perform(app: &App, arguments: &Arguments) -> Result<(), Failure> {
    let output = Output::from(&arguments.view);
    output.deliver(&match &arguments.model {
        Some(name) => {
            let info = app.entry(name)?.info();
            Answer::new(name, || describe(info), || document(info))
        }
        None => {
            let infos = || app.entries.iter().map(|entry| entry.info());
            let documents = move || infos().map(document).collect::<Vec<Value>>();
            let text = move || infos().map(brief).collect::<Vec<_>>().join("\n");
            Answer::new("models", text, move || json!({ "models": documents() }))
        }
    })
}

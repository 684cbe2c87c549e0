//! `laws`: friction laws, and their forces against the sliding speed.

mod curve;
mod drawn;
mod exhibit;
mod found;
mod swing;

use clap::Args;
use serde_json::json;

use crate::app::answer::Answer;
use crate::app::arguments::{Destination, Settings};
use crate::app::failure::{Failure, refuse};
use crate::app::offer::App;
use crate::app::output::Output;
use exhibit::{Exhibit, Wish};
use found::{Found, acting, find, lone, names};

/// Show friction laws: their formulas, and force against sliding speed
#[derive(Debug, Clone, Args)]
#[command(
    after_help = "Of a model, the laws of its contacts are shown at its parameters and its start"
)]
pub(in crate::app) struct Arguments {
    /// A law or a model; all laws without it
    law: Option<String>,
    #[command(flatten)]
    settings: Settings,
    #[command(flatten)]
    wish: Wish,
    #[command(flatten)]
    destination: Destination,
}

pub(in crate::app) fn perform(app: &App, arguments: &Arguments) -> Result<(), Failure> {
    match &arguments.law {
        Some(name) => one(app, name, arguments),
        None => all(app, arguments),
    }
}

fn one(app: &App, name: &str, arguments: &Arguments) -> Result<(), Failure> {
    let (set, wish) = (&arguments.settings.set, &arguments.wish);
    let exhibits = match find(app, name)? {
        Found::Law(law) => vec![lone(law, set, wish)?],
        Found::Model(entry) => acting(entry, set, wish)?,
    };
    let texts: Vec<&str> = exhibits.iter().map(|one| one.text.as_str()).collect();
    deliver(name, texts.join("\n"), exhibits, arguments)
}

fn all(app: &App, arguments: &Arguments) -> Result<(), Failure> {
    if let Some(set) = arguments.settings.set.first() {
        return refuse!(
            "`--set {}` sets a parameter of one law or model: name it, as in `laws {}`",
            set.word,
            names(app).first().map_or("", String::as_str)
        );
    }
    let wish = Wish {
        smoothing: None,
        amplitude: None,
        ..arguments.wish
    };
    let exhibits = app.laws.iter().map(|law| lone(law, &[], &wish));
    let exhibits = exhibits.collect::<Result<Vec<_>, _>>()?;
    let listed: Vec<&str> = exhibits.iter().map(|one| one.listing.as_str()).collect();
    let hint = format!(
        "{}`laws MODEL` draws the laws that act in a model: {}\n",
        if listed.is_empty() { "" } else { "\n" },
        app.names().join(", ")
    );
    deliver("laws", listed.join("\n") + &hint, exhibits, arguments)
}

fn deliver(
    name: &str,
    text: String,
    exhibits: Vec<Exhibit>,
    arguments: &Arguments,
) -> Result<(), Failure> {
    let document = match exhibits.as_slice() {
        [one] if name != "laws" => one.document.clone(),
        all => json!({ "laws": all.iter().map(|one| &one.document).collect::<Vec<_>>() }),
    };
    let answer = Answer::new(name, || text.clone(), || &document);
    let answer = exhibits.iter().fold(answer, |answer, one| {
        answer
            .sheet(&*one.name, || one.sheet.clone())
            .figure(&*one.name, || one.figure.clone())
    });
    Output::open(&arguments.destination)?.deliver(&answer)
}

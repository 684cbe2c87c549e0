//! `needs`: the least of a model that answers.

mod document;
mod picture;
mod text;

use std::ops::ControlFlow;

use clap::Args;

use crate::app::answer::Answer;
use crate::app::arguments::{Period, Subject, Unresumable};
use crate::app::failure::{Failure, refuse};
use crate::app::interrupt;
use crate::app::offer::App;
use crate::app::progress::Progress;
use crate::app::request::request;
use crate::app::values::{Range, Reading};
use crate::field::Design;
use crate::study::{Case, Dynamics, NeedsRecord, Topic};

/// The accuracy if nothing is said.
const ACCURACY: f64 = 1e-3;
/// What is done all the time.
const LOOKING: &str = "looking for the least that answers";

/// Find the least that answers to an accuracy: modes, contacts, parameters, copies; and what the model lacks
#[derive(Debug, Clone, Args)]
#[command(
    after_help = "The accuracy is 1e-3 if none is given. Of a structure, the displacements of its points are the answer. The exit \
                  code is 1 where the model lacks something that the scene asks for"
)]
pub(in crate::app) struct Arguments {
    #[command(flatten)]
    subject: Subject,
    #[command(flatten)]
    guess: Period,
    /// A parameter, to be judged at both A and B and where the branch between them reaches farthest
    #[arg(long, value_name = "NAME=A..B", value_parser = Reading(Range::read))]
    along: Option<Range>,
    #[command(flatten)]
    resume: Unresumable,
}

pub(in crate::app) fn perform(app: &App, arguments: &Arguments) -> Result<(), Failure> {
    arguments.resume.refuse()?;
    let range = arguments.along.as_ref();
    let asked = request(app, &arguments.subject, range, arguments.guess.period)?;
    let (info, output) = (asked.info, &asked.output);
    if let Dynamics::Smoothed(_) = asked.case.dynamics {
        return refuse!(
            "`needs` compares copies with the exact system by itself: leave out `--smooth`"
        );
    }
    if asked.case.along.map(|along| along.design) == Some(Design::Smoothing) {
        return refuse!("`needs` goes through the sizes by itself: `--along` takes a parameter");
    }
    let case = Case {
        accuracy: arguments.subject.accuracy.unwrap_or(ACCURACY),
        ..asked.case.clone()
    };
    let progress = Progress::endless(output, LOOKING);
    let watch = |topic: Topic| -> ControlFlow<()> {
        progress.say(format!("{LOOKING}: {}", text::topic(topic)));
        interrupt::verdict()
    };
    let record = asked.got(asked.entry.needs_watched(&case, &watch))?;
    drop(progress);
    let mut answer = Answer::new(
        "needs",
        || text::describe(info, &case, &record),
        || document::document(info, &record),
    );
    if !record.modes.is_empty() {
        answer = answer.figure("needs", || picture::picture(info, &record));
    }
    output.deliver(&answer)?;
    if record.interrupted {
        return Err(output.interrupted("not all was looked at"));
    }
    verdict(&record)
}

fn verdict(record: &NeedsRecord) -> Result<(), Failure> {
    match record.lacks.first() {
        Some(lack) => Err(Failure::failed(format!(
            "the model lacks something: {}",
            text::lack(lack)
        ))),
        None => Ok(()),
    }
}

//! `simulate`: one motion from its start.

mod answer;

use clap::Args;

use crate::app::arguments::Subject;
use crate::app::failure::Failure;
use crate::app::offer::App;
use crate::app::progress::Progress;
use crate::app::request::request;
use crate::app::section::{Cut, with_points};
use crate::app::values::Reading;
use crate::app::words::positive;
use crate::study::Span;
pub(super) use answer::drawn;

/// Follow one motion from its start
#[derive(Debug, Clone, Args)]
pub(in crate::app) struct Arguments {
    #[command(flatten)]
    subject: Subject,
    /// How long
    #[arg(long, value_name = "T", default_value = "100", value_parser = Reading(positive))]
    time: f64,
    #[command(flatten)]
    cut: Cut,
}

pub(in crate::app) fn perform(app: &App, arguments: &Arguments) -> Result<(), Failure> {
    let asked = request(app, &arguments.subject, None, None)?;
    let (info, case, time) = (asked.info, &asked.case, arguments.time);
    let section = arguments.cut.of(info)?;
    let progress = Progress::endless(&asked.output, "following the motion");
    let motion = asked.got(asked.entry.motion(case, time))?;
    let answer = answer::answer(info, case, &motion, time);
    let answer = with_points(answer, &asked, case, section, Span::Time(time))?;
    drop(progress);
    asked.output.deliver(answer.part("work", "", motion.work))
}

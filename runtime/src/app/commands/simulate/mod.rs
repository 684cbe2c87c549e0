//! `simulate`: one motion from its start.

mod answer;
mod picture;

use clap::Args;

use crate::app::arguments::Subject;
use crate::app::failure::Failure;
use crate::app::interrupt;
use crate::app::journal::Journal;
use crate::app::offer::App;
use crate::app::output::Output;
use crate::app::progress::Progress;
use crate::app::request::{Request, request};
use crate::app::section::{Cut, with_points};
use crate::app::show::Show;
use crate::app::text::{number, short};
use crate::app::values::{Reading, counted};
use crate::app::words::positive;
use crate::model::ModelInfo;
use crate::study::{Limits, Span, Trajectory};
pub(super) use answer::drawn;

/// Numbers in a table, and in the document; a longer motion is thinned to it.
const NUMBERS: usize = 1 << 18;
/// Numbers in memory where only the ends are told.
const FEW: usize = 1 << 12;
/// Digits shown of a time.
const TIME: usize = 6;

/// Follow one motion from its start
#[derive(Debug, Clone, Args)]
pub(in crate::app) struct Arguments {
    #[command(flatten)]
    subject: Subject,
    /// How long
    #[arg(long, value_name = "T", default_value = "100", value_parser = Reading(positive))]
    time: f64,
    /// Most steps of the integrator
    #[arg(long, value_name = "N", default_value = "100000000", value_parser = counted::<1, 1_000_000_000_000_000>())]
    steps: usize,
    #[command(flatten)]
    cut: Cut,
    #[command(flatten)]
    show: Show,
}

pub(in crate::app) fn perform(app: &App, arguments: &Arguments) -> Result<(), Failure> {
    let asked = request(app, &arguments.subject, None, None)?;
    let (info, case, output) = (asked.info, &asked.case, &asked.output);
    let section = arguments.cut.of(info)?;
    let shown = arguments.show.quantities(info)?;
    let progress = Progress::along(output, "following the motion");
    let motion = follow(&asked, arguments, &progress)?;
    let answer = answer::answer(&asked, &motion, &shown, arguments.time);
    let answer = if motion.time < arguments.time {
        answer
    } else {
        with_points(answer, &asked, case, section, Span::Time(arguments.time))?
    };
    drop(progress);
    output.deliver(&answer.part("work", || motion.work))?;
    verdict(info, output, &motion, arguments.time)
}

/// How much of a motion is kept for a table, and followed at most.
pub(super) fn limits(output: &Output, steps: u64) -> Limits {
    let numbers = if output.is_wanted_whole() {
        NUMBERS
    } else {
        FEW
    };
    Limits { steps, numbers }
}

/// The motion as far as it goes, its table growing on the way.
fn follow(
    asked: &Request<'_>,
    arguments: &Arguments,
    progress: &Progress,
) -> Result<Trajectory, Failure> {
    let limits = limits(&asked.output, arguments.steps as u64);
    let mut table = Table::new(asked);
    let mut foreseen = false;
    let mut watch = |motion: &Trajectory| {
        table.take(motion);
        if !foreseen && motion.time < arguments.time {
            foreseen = true;
            foresee(&asked.output, motion, arguments.time, limits.steps);
        }
        let share = motion.time / arguments.time;
        progress.reach(share, format!("t = {}", number(motion.time, TIME)))
    };
    let (entry, time) = (asked.entry, arguments.time);
    asked.got(entry.motion_within(&asked.case, time, limits, &mut watch))
}

/// Says early that a motion will not be followed to its end.
fn foresee(output: &Output, motion: &Trajectory, time: f64, most: u64) {
    let rate = motion.steps() as f64 / motion.time;
    if rate * time > most as f64 {
        output.note(format!(
            "note: the time {} would take some {} steps, if it goes on as it began; it ends after {}, near t = {}",
            short(time),
            number(rate * time, 2),
            short(most as f64),
            number(most as f64 / rate, 2),
        ));
    }
}

/// The table of a motion, as far as that has come.
struct Table<'a> {
    info: &'a ModelInfo,
    journal: Journal,
    /// Rows that are in it.
    rows: usize,
    /// Of how many samples it has one.
    every: usize,
}

impl<'a> Table<'a> {
    fn new(asked: &Request<'a>) -> Self {
        let head = answer::columns(asked.info, &Trajectory::default()).head();
        Self {
            info: asked.info,
            journal: asked.output.journal("trajectory", &head),
            rows: 0,
            every: 1,
        }
    }

    fn take(&mut self, motion: &Trajectory) {
        let columns = answer::columns(self.info, motion);
        let rows = |from: usize| (from..motion.times.len()).map(|i| columns.row(&i));
        if motion.every == self.every {
            self.journal.add(rows(self.rows));
        } else {
            self.journal.replace(rows(0));
        }
        (self.rows, self.every) = (motion.times.len(), motion.every);
    }
}

/// Why a motion was not followed to its end, if it was not.
fn verdict(
    info: &ModelInfo,
    output: &Output,
    motion: &Trajectory,
    time: f64,
) -> Result<(), Failure> {
    if motion.time >= time {
        return Ok(());
    }
    let unit = crate::app::text::time_unit(info);
    let found = format!(
        "the motion was followed to t = {}{unit} of {}{unit}",
        number(motion.time, TIME),
        short(time)
    );
    if interrupt::asked() {
        return Err(output.interrupted(&found));
    }
    Err(Failure::failed(format!(
        "{found}, for {} steps: `--steps` allows more",
        motion.steps()
    )))
}

//! `diagram`: where motions meet a section, for many values of a design variable.

mod notes;
mod sheets;

use std::sync::{Mutex, PoisonError};

use clap::ArgMatches;

use super::App;
use super::failure::Failure;
use super::json;
use super::options::{Request, request, text};
use super::orbit::work;
use super::output::Journal;
use super::picture;
use super::progress::Progress;
use super::resume::{Notes, Question};
use super::section::section;
use super::text::{followed, number, parameters, table};
use super::words::{count, unknown};
use crate::model::ModelInfo;
use crate::poincare::{Section, Surface};
use crate::study::{
    Along, Case, Diagram, DiagramRecord, Known, Motion, Seen, Slice, Sweep, SweepRecord,
};

/// Digits shown of the design variable.
const DIGITS: usize = 6;

pub(super) fn perform(app: &App, options: &ArgMatches) -> Result<(), Failure> {
    if text(options, "along").is_none() {
        let message = "`diagram` needs `--along NAME=A..B`: which parameter, from where to where";
        return Err(Failure::usage(message));
    }
    let mut diagram = counts(options)?;
    let Request {
        entry,
        case,
        output,
    } = request(app, options)?;
    let info = entry.info();
    diagram.section = section(info, options)?.unwrap_or_default();
    let shown = shown(info, options, &diagram.section)?;
    let progress = Progress::along(&output);
    let mut known = Known::default();
    let mut recall =
        |line: &str| notes::read(line).map(|(sweep, slice)| known.insert(&sweep, slice));
    let question = question(app, info, &case, &diagram);
    let notes = Notes::open(&output, options, "diagram", &question, &mut recall)?;
    let papers = Mutex::new(Papers {
        along: case.along,
        points: output.journal("points"),
        values: output.journal("values"),
        notes,
    });
    let watch = |seen: Seen<'_>| {
        let mut papers = papers.lock().unwrap_or_else(PoisonError::into_inner);
        papers.take(info, &seen);
        progress.reach(seen.share, String::new())
    };
    let record = entry
        .diagram(&case, &diagram, &known, &watch)
        .map_err(|error| Failure::of(&error, info))?;
    drop(progress);
    let picture = picture::diagram(info, &record, shown);
    let drawn = output.draw([("diagram", picture)]);
    let document = json::DiagramDocument::new(info, &case, &record);
    let name = &followed(info, &record.along);
    let slices = || {
        let sweeps = record.sweeps.iter();
        sweeps.flat_map(|sweep| sweep.slices.iter().map(|slice| (sweep.name, slice)))
    };
    output.deliver(
        "diagram",
        &describe(info, &case, &record),
        &document,
        &[
            ("points", sheets::points(info, name, slices())),
            ("values", sheets::values(info, name, slices())),
        ],
    )?;
    drawn?;
    if record.missing > 0 {
        let count = slices().count();
        return Err(output.interrupted(&format!("{count} values were found")));
    }
    let papers = papers.into_inner().unwrap_or_else(PoisonError::into_inner);
    papers.notes.discard();
    failures(info, &record)
}

/// What is asked, as far as the answer depends on it: not on the number of threads.
fn question(app: &App, info: &ModelInfo, case: &Case, diagram: &Diagram) -> Question {
    Question::new(app.version, info, case)
        .and("`--section`", diagram.section.describe(info))
        .exactly("the section", &diagram.section)
        .and("`--sweep`", diagram.sweep.name())
        .and("`--values`", diagram.values)
        .and("`--settle`", diagram.settle)
        .and("`--points`", diagram.points)
        .exactly("`--lyapunov`", &diagram.lyapunov)
}

/// What is written of each value as it is found.
struct Papers {
    along: Option<Along>,
    points: Journal,
    values: Journal,
    notes: Notes,
}

impl Papers {
    fn take(&mut self, info: &ModelInfo, seen: &Seen<'_>) {
        let Seen { sweep, slice, .. } = *seen;
        if !seen.known {
            self.notes.add(|| notes::written(sweep, slice));
        }
        let along = self
            .along
            .map_or(String::new(), |along| followed(info, &along));
        self.points
            .add(|| sheets::points(info, &along, [(sweep, slice)]));
        self.values
            .add(|| sheets::values(info, &along, [(sweep, slice)]));
    }
}

/// All that is counted; the section is not known yet.
fn counts(options: &ArgMatches) -> Result<Diagram, Failure> {
    let read = |name: &str, bounds| {
        text(options, name)
            .map(|word| count(&format!("--{name}"), word, bounds))
            .transpose()
    };
    let word = text(options, "sweep").unwrap_or_default();
    let sweep = Sweep::ALL.into_iter().find(|sweep| sweep.name() == word);
    let sweep = sweep.ok_or_else(|| {
        let names = Sweep::ALL.map(Sweep::name);
        Failure::usage(unknown("`--sweep` knows no way", word, &names))
    })?;
    Ok(Diagram {
        section: Section::default(),
        sweep,
        values: read("values", [2, 1_000_000])?.unwrap_or(200),
        settle: read("settle", [0, 100_000_000])?.unwrap_or(300),
        points: read("points", [1, 10_000_000])?.unwrap_or(64),
        lyapunov: read("lyapunov", [2, 100_000_000])?,
        threads: read("threads", [1, 4096])?,
    })
}

/// The state that is drawn: the one asked for, else the first that the section leaves free.
fn shown(info: &ModelInfo, options: &ArgMatches, section: &Section) -> Result<usize, Failure> {
    let Some(name) = text(options, "show") else {
        let fixed = matches!(section.surface, Surface::Level { state: 0, .. });
        return Ok(usize::from(fixed && info.states.len() > 1));
    };
    let place = info.states.iter().position(|state| state.name == name);
    place.ok_or_else(|| {
        let names: Vec<&str> = info.states.iter().map(|state| state.name).collect();
        let what = format!("`{}` has no state", info.command);
        Failure::usage(unknown(&what, name, &names))
    })
}

fn describe(info: &ModelInfo, case: &Case, record: &DiagramRecord) -> String {
    let name = &followed(info, &record.along);
    let section = record.diagram.section.describe(info);
    let mut text = format!(
        "{}, {}: a Poincaré diagram along {name}, section {section}\n  {}\n\n",
        info.command,
        case.dynamics,
        parameters(info, case)
    );
    let head = ["sweep", name, "to", "values", "motion"].map(str::to_owned);
    let mut rows = vec![head.to_vec()];
    for sweep in &record.sweeps {
        rows.extend(runs(sweep).iter().map(|run| row(sweep, run)));
    }
    text.push_str(&table(&rows));
    let count: usize = record.sweeps.iter().map(|sweep| sweep.slices.len()).sum();
    text.push_str(&format!("\n  {count} values; {}\n", work(&record.work())));
    text
}

/// Neighbouring values with the same kind of motion.
fn runs(sweep: &SweepRecord) -> Vec<&[Slice]> {
    let kind = |slice: &Slice| slice.motion.name();
    sweep.slices.chunk_by(|a, b| kind(a) == kind(b)).collect()
}

fn row(sweep: &SweepRecord, run: &[Slice]) -> Vec<String> {
    let end = |slice: Option<&Slice>| slice.map_or(String::new(), |s| number(s.r, DIGITS));
    let motion = run.first().map_or(String::new(), |s| s.motion.name());
    vec![
        sweep.name.to_owned(),
        end(run.first()),
        end(run.last()),
        run.len().to_string(),
        motion + &exponents(run),
    ]
}

/// The range of the Lyapunov exponents of a run.
fn exponents(run: &[Slice]) -> String {
    let values = || {
        let known = run.iter().filter_map(|slice| slice.lyapunov.as_ref());
        known.filter_map(|found| found.as_ref().ok()?.exponent)
    };
    let (low, high) = (
        values().fold(f64::INFINITY, f64::min),
        values().fold(f64::NEG_INFINITY, f64::max),
    );
    if low > high {
        return String::new();
    }
    format!(", exponent {} to {}", number(low, 3), number(high, 3))
}

/// Values without an answer, if there are any.
fn failures(info: &ModelInfo, record: &DiagramRecord) -> Result<(), Failure> {
    let name = record.along.name(info);
    let slices = record.sweeps.iter().flat_map(|sweep| &sweep.slices);
    let failed: Vec<(f64, &str)> = slices
        .filter_map(|slice| match &slice.motion {
            Motion::Failed(reason) => Some((slice.r, reason.as_str())),
            _ => None,
        })
        .collect();
    match failed.as_slice() {
        [] => Ok(()),
        [(r, reason), ..] => Err(Failure::failed(format!(
            "{} values have no answer, the first at {name} = {r}: {reason}",
            failed.len()
        ))),
    }
}

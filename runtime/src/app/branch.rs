//! `branch`: orbits along a design variable.

use std::ops::ControlFlow;

use clap::ArgMatches;

use super::App;
use super::curve;
use super::failure::Failure;
use super::json;
use super::options::{Request, request, text};
use super::output::{Journal, Output};
use super::passages::Passages;
use super::picture;
use super::progress::Progress;
use super::resume::Question;
use super::spreadsheet::Spreadsheet;
use super::text::{digits, followed, label, number as significant, parameters, table, timed};
use super::words::{number, unknown};
use crate::model::ModelInfo;
use crate::study::{Along, Beginning, BranchRecord, Case, Ended, OrbitRecord, Switch};

pub(super) fn perform(app: &App, options: &ArgMatches) -> Result<(), Failure> {
    if text(options, "along").is_none() {
        let message = "`branch` needs `--along NAME=A..B`: what to follow, from where to where";
        return Err(Failure::usage(message));
    }
    if curve::wanted(options)? {
        return curve::perform(app, request(app, options)?, options);
    }
    let Request {
        entry,
        mut case,
        output,
    } = request(app, options)?;
    let info = entry.info();
    case.switch = switch(options)?;
    case.beginning = beginning(options, &case)?;
    if let Beginning::At(value) = case.beginning {
        case = case.at(value);
    }
    let question = Question::new(app.version, info, &case);
    let mut passages = Passages::open(&output, options, "branch", &question)?;
    let progress = Progress::along(&output);
    let mut rows = Rows::new(&output, info, &case);
    let mut watch = |point: &OrbitRecord| rows.add(point, &progress);
    let branch = passages.recorded(entry).branch(&case, &mut watch);
    let branch = branch.map_err(|error| Failure::of(&error, info))?;
    drop(progress);
    deliver(&output, info, &case, &branch)?;
    passages.discard();
    let reason = |ended: &Ended| format!("the branch ended, {}: {}", ended.word(), ended.reason);
    if let Some(ended) = branch.unlocated() {
        return Err(Failure::failed(reason(ended)));
    }
    output.note(reason(&branch.ended));
    Ok(())
}

/// What is written and shown of each orbit as it is found.
pub(super) struct Rows<'a> {
    info: &'a ModelInfo,
    along: Option<Along>,
    journal: Journal,
}

impl<'a> Rows<'a> {
    pub(super) fn new(output: &Output, info: &'a ModelInfo, case: &Case) -> Self {
        Self {
            info,
            along: case.along,
            journal: output.journal("branch"),
        }
    }

    pub(super) fn add(&mut self, point: &OrbitRecord, progress: &Progress) -> ControlFlow<()> {
        let (Some(along), Some(r)) = (self.along, point.r) else {
            return ControlFlow::Continue(());
        };
        let (info, name) = (self.info, followed(self.info, &along));
        self.journal
            .add(|| Spreadsheet::orbits(info, &name, std::slice::from_ref(point)));
        let message = format!("{} = {}", along.name(info), significant(r, 6));
        progress.reach(along.share(r), message)
    }
}

/// Answers with a branch.
///
/// # Errors
/// It was interrupted, or the answer cannot be written.
pub(super) fn deliver(
    output: &Output,
    info: &ModelInfo,
    case: &Case,
    branch: &BranchRecord,
) -> Result<(), Failure> {
    let document = json::Branch::new(info, case, branch);
    let drawn = output.draw([("branch", picture::branch(info, branch))]);
    let text = describe(info, case, branch);
    output.deliver("branch", &text, &document, &sheets(info, branch))?;
    drawn?;
    if branch.is_interrupted() {
        let count: usize = branch.all().iter().map(|one| one.points.len()).sum();
        return Err(output.interrupted(&format!("{count} orbits were found")));
    }
    Ok(())
}

/// Writes a branch to the folder, if there is one, beside the answer.
pub(super) fn keep(
    output: &Output,
    info: &ModelInfo,
    case: &Case,
    branch: &BranchRecord,
) -> Result<(), Failure> {
    let document = json::Branch::new(info, case, branch);
    output.draw([("branch", picture::branch(info, branch))])?;
    output.keep("branch", &document, &sheets(info, branch))
}

/// The tables of a branch and of those that leave it.
fn sheets(info: &ModelInfo, branch: &BranchRecord) -> Vec<(String, Spreadsheet)> {
    let name = followed(info, &branch.along);
    let all = branch.all().into_iter().enumerate();
    all.map(|(i, one)| (sheet(i), Spreadsheet::orbits(info, &name, &one.points)))
        .collect()
}

/// The branches to switch to, as `--switch` and `--depth` say.
fn switch(options: &ArgMatches) -> Result<Switch, Failure> {
    let depth = text(options, "depth");
    let Some(word) = text(options, "switch") else {
        return match depth {
            Some(depth) => Err(Failure::usage(format!(
                "`--depth {depth}` says how deep to switch, but not at what: add `--switch flips`"
            ))),
            None => Ok(Switch::default()),
        };
    };
    let depth = match depth {
        None => 1,
        Some(word) => word
            .trim()
            .parse()
            .ok()
            .filter(|depth| *depth > 0)
            .ok_or_else(|| {
                Failure::usage(format!("`--depth {word}`: give a whole number from 1"))
            })?,
    };
    let (flips, branch_points) = match word {
        "flips" => (true, false),
        "branch-points" => (false, true),
        "all" => (true, true),
        _ => {
            let what = "`--switch` knows no";
            let message = unknown(what, word, &["flips", "branch-points", "all"]);
            return Err(Failure::usage(message));
        }
    };
    Ok(Switch {
        flips,
        branch_points,
        depth,
    })
}

/// Where `--from` says that the branch begins: between the ends of `--along`, or at a Hopf point.
fn beginning(options: &ArgMatches, case: &Case) -> Result<Beginning, Failure> {
    let (Some(word), Some(along)) = (text(options, "from"), case.along) else {
        return Ok(Beginning::End);
    };
    if word == "hopf" {
        return Ok(Beginning::Hopf);
    }
    let place = format!("--from {word}");
    let value = number(&place, word)?;
    if (value - along.from) * (value - along.to) > 0.0 {
        return Err(Failure::usage(format!(
            "`{place}` lies outside `--along`, which goes from {} to {}",
            along.from, along.to
        )));
    }
    Ok(Beginning::At(value))
}

fn describe(info: &ModelInfo, case: &Case, branch: &BranchRecord) -> String {
    let name = branch.along.name(info);
    let mut text = format!(
        "{}, {}: a branch of periodic orbits along {name}\n",
        info.command, case.dynamics
    );
    text.push_str(&format!("  {}\n\n", parameters(info, case)));
    text.push_str(&table(&points(info, branch)));
    if !branch.special.is_empty() {
        text.push_str(&format!("\n{}", table(&special(info, branch))));
    }
    for (i, below) in branch.all().into_iter().enumerate().skip(1) {
        let from = below.from.as_deref().unwrap_or("another");
        let count = below.points.first().map_or(0, |point| point.period_count);
        text.push_str(&format!(
            "\nbranch {i}, period {count}, leaves its parent at {from}; {} points, ended: {}\n",
            below.points.len(),
            below.ended.word()
        ));
        if !below.special.is_empty() {
            text.push_str(&table(&special(info, below)));
        }
    }
    text
}

/// The name of the file of a branch: `branch`, and `branch-1`, ... of those that leave it.
fn sheet(number: usize) -> String {
    match number {
        0 => "branch".to_owned(),
        _ => format!("branch-{number}"),
    }
}

fn points(info: &ModelInfo, branch: &BranchRecord) -> Vec<Vec<String>> {
    let largest = info.states.first().map_or(String::new(), |state| {
        label(&format!("max |{}|", state.name), state.unit)
    });
    let head = [
        followed(info, &branch.along),
        timed(info, "period", "s"),
        largest,
        "|multiplier|".to_owned(),
        "stability".to_owned(),
    ];
    let mut rows = vec![head.to_vec()];
    rows.extend(branch.points.iter().map(point));
    rows
}

fn point(orbit: &OrbitRecord) -> Vec<String> {
    let digits = digits(orbit.error_estimate).min(9);
    let largest = orbit.floquet.multipliers.first();
    vec![
        orbit.r.map_or(String::new(), |r| significant(r, digits)),
        significant(orbit.period, digits),
        orbit
            .max_abs
            .first()
            .map_or(String::new(), |&value| significant(value, digits)),
        largest.map_or(String::new(), |multiplier| {
            significant(multiplier.norm(), 5)
        }),
        orbit.floquet.stability.name().to_owned(),
    ]
}

fn special(info: &ModelInfo, branch: &BranchRecord) -> Vec<Vec<String>> {
    let (name, period) = (followed(info, &branch.along), timed(info, "period", "s"));
    let mut rows = vec![
        ["special", "kind", &name, &period, ""]
            .map(str::to_owned)
            .to_vec(),
    ];
    rows.extend(branch.special.iter().map(|point| {
        vec![
            point.label.clone(),
            point.kind.to_owned(),
            significant(point.r, 10),
            significant(point.period, 10),
            point
                .criticality
                .or(point.note.as_deref())
                .unwrap_or("")
                .to_owned(),
        ]
    }));
    rows
}

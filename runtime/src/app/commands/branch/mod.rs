//! `branch`: orbits along a design variable.

mod answer;

use clap::Args;

use super::orbit;
use crate::app::arguments::{Curve, Period, Resume, Subject, Way};
use crate::app::failure::{Failure, refuse};
use crate::app::harmonics::Harmonics;
use crate::app::offer::App;
use crate::app::passages::Passages;
use crate::app::progress::{Progress, Trail};
use crate::app::question::Question;
use crate::app::request::{Request, request};
use crate::app::show::Show;
use crate::app::values::{Range, Reading, one_of};
use crate::app::words::number;
use crate::model::ModelInfo;
use crate::study::{Beginning, BranchRecord, Case, OrbitRecord, Switch};
pub(super) use answer::{answer, extents, found};

/// What is done before anything is found.
pub(super) const FIRST: &str = "looking for the first orbit";

/// Follow a periodic orbit along a parameter, or along the size of the smoothing
#[derive(Debug, Clone, Args)]
pub(in crate::app) struct Arguments {
    #[command(flatten)]
    pub(in crate::app) subject: Subject,
    #[command(flatten)]
    pub(in crate::app) guess: Period,
    #[command(flatten)]
    pub(in crate::app) way: Way,
    /// Begin at this value between A and B and follow both ways, or begin at the equilibrium's first `hopf` point
    #[arg(long, value_name = "VALUE", value_parser = Reading(From::read))]
    pub(in crate::app) from: Option<From>,
    /// Follow the branches that leave it, too: at flips, branch-points, or all
    #[arg(long, value_name = "WHERE", value_parser = Reading(switches))]
    pub(super) switch: Option<Switches>,
    /// How many switches deep: 1 without --depth
    #[arg(long, value_name = "N", value_parser = Reading(depth))]
    depth: Option<usize>,
    #[command(flatten)]
    pub(in crate::app) harmonics: Harmonics,
    #[command(flatten)]
    show: Show,
    #[command(flatten)]
    pub(in crate::app) curve: Curve,
    #[command(flatten)]
    pub(in crate::app) resume: Resume,
}

impl Arguments {
    /// What is followed.
    ///
    /// # Errors
    /// Nothing is.
    pub(in crate::app) fn range(&self) -> Result<&Range, Failure> {
        self.way.along.as_ref().ok_or_else(|| {
            let message = "`branch` needs `--along NAME=A..B`: what to follow, from where to where";
            Failure::usage(message)
        })
    }
}

/// Where the branch begins.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::app) struct From {
    pub(in crate::app) word: String,
    beginning: Beginning,
}

impl From {
    fn read(option: &str, word: &str) -> Result<Self, Failure> {
        let beginning = match word {
            "hopf" => Beginning::Hopf,
            _ => Beginning::At(number(&format!("{option} {word}"), word)?),
        };
        Ok(Self {
            word: word.to_owned(),
            beginning,
        })
    }
}

/// What to switch to, by its name.
pub(super) type Switches = (&'static str, Switch);

fn switches(option: &str, word: &str) -> Result<Switches, Failure> {
    let named = |name, flips, branch_points| {
        let depth = 1;
        (
            name,
            Switch {
                flips,
                branch_points,
                depth,
            },
        )
    };
    let all = [
        named("flips", true, false),
        named("branch-points", false, true),
        named("all", true, true),
    ];
    one_of(all, |(name, _)| name, &format!("`{option}` knows no"), word)
}

fn depth(option: &str, word: &str) -> Result<usize, Failure> {
    let depth = word.trim().parse().ok().filter(|depth| *depth > 0);
    depth.ok_or_else(|| Failure::usage(format!("`{option} {word}`: give a whole number from 1")))
}

impl Arguments {
    /// The case with the beginning of its branch, and with the branches to switch to.
    pub(super) fn of(&self, info: &ModelInfo, mut case: Case) -> Result<Case, Failure> {
        case.harmonics = self.harmonics.of(info);
        case.switch = self.switch()?;
        case.beginning = self.beginning(&case)?;
        Ok(match case.beginning {
            Beginning::At(value) => case.at(value),
            Beginning::End | Beginning::Hopf => case,
        })
    }

    /// The states that are shown.
    pub(in crate::app) fn shown(&self, info: &ModelInfo) -> Result<Vec<usize>, Failure> {
        Ok(self.show.states(info)?.unwrap_or_else(|| vec![0]))
    }

    fn switch(&self) -> Result<Switch, Failure> {
        match (self.switch, self.depth) {
            (None, None) => Ok(Switch::default()),
            (None, Some(depth)) => refuse!(
                "`--depth {depth}` says how deep to switch, but not at what: add `--switch flips`"
            ),
            (Some((_, switch)), depth) => Ok(Switch {
                depth: depth.unwrap_or(switch.depth),
                ..switch
            }),
        }
    }

    /// Where the branch begins: between the ends of its way, or at a Hopf point.
    fn beginning(&self, case: &Case) -> Result<Beginning, Failure> {
        let (Some(from), Some(along)) = (&self.from, case.along) else {
            return Ok(Beginning::End);
        };
        match from.beginning {
            Beginning::At(value) if (value - along.from) * (value - along.to) > 0.0 => {
                refuse!(
                    "`--from {}` lies outside `--along`, which goes from {} to {}",
                    from.word,
                    along.from,
                    along.to
                )
            }
            beginning => Ok(beginning),
        }
    }
}

pub(in crate::app) fn perform(app: &App, arguments: &Arguments) -> Result<(), Failure> {
    let range = arguments.range()?;
    let mut asked = request(app, &arguments.subject, Some(range), arguments.guess.period)?;
    let shown = arguments.shown(asked.info)?;
    asked.case = arguments.of(asked.info, asked.case)?;
    let progress = Progress::along(&asked.output, FIRST);
    let question = Question::new(app.version, asked.info, &asked.case);
    let mut passages = Passages::open(&asked.output, &arguments.resume, "branch", &question)?;
    let mut trail = trail(&asked, &progress)?;
    let mut watch = |point: &OrbitRecord| trail.reach(point.r, point);
    let branch = asked.got(
        passages
            .recorded(&asked.entry.telling(progress.news(FIRST)))
            .branch_watched(&asked.case, &mut watch),
    )?;
    drop(progress);
    deliver(&asked, &branch, &shown)?;
    passages.discard();
    let ended = branch.unlocated().unwrap_or(&branch.ended);
    asked.output.close("branch", ended, "")
}

/// The orbits of a branch as they are found.
pub(super) fn trail<'a>(
    asked: &Request<'_>,
    progress: &'a Progress,
) -> Result<Trail<'a, OrbitRecord>, Failure> {
    let along = asked.along()?;
    let columns = orbit::columns(asked.info, &along, &asked.case.harmonics);
    Ok(Trail::new(asked, along, "branch", columns, progress))
}

/// Answers with a branch.
///
/// # Errors
/// It was interrupted, or the answer cannot be written.
pub(super) fn deliver(
    asked: &Request<'_>,
    branch: &BranchRecord,
    shown: &[usize],
) -> Result<(), Failure> {
    asked.output.deliver(&answer(asked, branch, shown))?;
    if branch.is_interrupted() {
        let count: usize = branch.all().iter().map(|one| one.points.len()).sum();
        return Err(asked
            .output
            .interrupted(&format!("{count} orbits were found")));
    }
    Ok(())
}

//! Arguments that several commands share.

use std::path::PathBuf;

use clap::Args;

use super::failure::{Failure, refuse};
use super::saved::Start;
use super::values::{Assignment, Range, Reading, SmoothCopy, accuracy};
use super::words::positive;

#[derive(Debug, Clone, Args)]
pub(super) struct View {
    /// Print one JSON document and nothing else
    #[arg(long)]
    pub(super) json: bool,
    /// Show no progress and no notes
    #[arg(long)]
    pub(super) quiet: bool,
}

#[derive(Debug, Clone, Args)]
pub(super) struct Destination {
    /// Write files to this folder, long tables row by row
    #[arg(long, value_name = "DIR")]
    pub(super) out: Option<PathBuf>,
    #[command(flatten)]
    pub(super) view: View,
}

#[derive(Debug, Clone, Args)]
pub(super) struct Settings {
    /// Set a parameter; may be given several times
    #[arg(long, value_name = "NAME=VALUE", value_parser = Reading(Assignment::read))]
    pub(super) set: Vec<Assignment>,
}

/// Which case of which model.
#[derive(Debug, Clone, Args)]
pub(super) struct Subject {
    /// A model, as `models` names it
    pub(super) model: Option<String>,
    #[command(flatten)]
    pub(super) settings: Settings,
    /// Friction by its set-valued law: the default
    #[arg(long)]
    pub(super) exact: bool,
    /// Friction by a smooth copy, for instance arctan:1e5
    #[arg(long, value_name = "KERNEL:SIZE", value_parser = Reading(SmoothCopy::read))]
    pub(super) smooth: Option<SmoothCopy>,
    /// Where to start; states left out keep their declared start. An orbit is then the motion on which that start settles. FILE.json is an orbit that was saved, FILE.json#PD1 a special point or FILE.json#3 a row of a branch, with their parameters and their friction
    #[arg(long, value_name = "NAME=VALUE,...", value_parser = Reading(Start::read))]
    pub(super) start: Option<Start>,
    /// Relative accuracy of period and extrema [default: 1e-9]
    #[arg(long, value_name = "REL", value_parser = Reading(accuracy))]
    pub(super) accuracy: Option<f64>,
    #[command(flatten)]
    pub(super) destination: Destination,
}

#[derive(Debug, Clone, Args)]
pub(super) struct Period {
    /// A guess of the period; with --start, Newton begins at once
    #[arg(long, value_name = "T", value_parser = Reading(positive))]
    pub(super) period: Option<f64>,
}

#[derive(Debug, Clone, Args)]
pub(super) struct Way {
    /// What to follow, from A to B; `smooth=A..B` follows the smoothing
    #[arg(long, value_name = "NAME=A..B", value_parser = Reading(Range::read))]
    pub(super) along: Option<Range>,
}

/// Whether a special point of the branch is followed in a second parameter.
#[derive(Debug, Clone, Args)]
pub(super) struct Curve {
    /// Follow a special point of the branch in this parameter too, from C to D: a fold, flip, torus, grazing or sliding point of orbits, a fold or Hopf point of equilibria
    #[arg(long, value_name = "NAME=C..D", value_parser = Reading(Range::read))]
    pub(super) and: Option<Range>,
    /// Which one, for instance PD1; the first without --of
    #[arg(long, value_name = "LABEL")]
    pub(super) of: Option<String>,
}

#[derive(Debug, Clone, Args)]
pub(super) struct Resume {
    /// Go on from what an interrupted run of the same command has left in --out DIR
    #[arg(long)]
    pub(super) resume: bool,
}

/// `--resume` where it has no meaning.
#[derive(Debug, Clone, Args)]
pub(super) struct Unresumable {
    #[arg(long = "resume", hide = true)]
    pub(super) resume: bool,
}

impl Unresumable {
    /// # Errors
    /// It is there.
    pub(super) fn refuse(&self) -> Result<(), Failure> {
        if self.resume {
            return refuse!(
                "`--resume` goes on with a `diagram`, a `branch`, a `trade`, a `map` or `attractors` only, which may take long: leave it out, and this is done anew"
            );
        }
        Ok(())
    }
}

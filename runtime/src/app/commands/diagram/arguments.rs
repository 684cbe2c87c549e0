//! Arguments of `diagram`.

use clap::Args;

use crate::app::arguments::{Resume, Subject, Way};
use crate::app::failure::Failure;
use crate::app::request::state;
use crate::app::section::Cut;
use crate::app::values::{Reading, one_of};
use crate::app::words::count;
use crate::model::ModelInfo;
use crate::poincare::{Section, Surface};
use crate::study::{Diagram, Sweep};

/// Draw a Poincaré diagram: let the motion settle at many values of a parameter, and note where it meets a section
#[derive(Debug, Clone, Args)]
#[group(skip)]
#[command(
    after_help = "A sweep begins each value where the one before ended, and so stays with its attractor; `--sweep fresh` \
                  begins each at the start. Nothing depends on the number of threads. A model with a drive is looked at \
                  once in each turn of it, unless `--section` says otherwise; its period-n counts turns of the drive"
)]
pub(in crate::app) struct Arguments {
    #[command(flatten)]
    pub(super) subject: Subject,
    #[command(flatten)]
    pub(super) way: Way,
    #[command(flatten)]
    pub(super) cut: Cut,
    /// `up`, `down`, `both` or `fresh`
    #[arg(long, value_name = "WAY", default_value = "both", value_parser = Reading(sweep))]
    sweep: Sweep,
    /// How many values of the parameter
    #[arg(long, value_name = "N", default_value = "200", value_parser = counted::<2, 1_000_000>())]
    values: usize,
    /// Points left out while the motion settles
    #[arg(long, value_name = "N", default_value = "300", value_parser = counted::<0, 100_000_000>())]
    settle: usize,
    /// Points noted at each value
    #[arg(long, value_name = "N", default_value = "64", value_parser = counted::<1, 10_000_000>())]
    points: usize,
    /// The largest Lyapunov exponent too, averaged over N laps
    #[arg(long, value_name = "N", value_parser = counted::<2, 100_000_000>())]
    lyapunov: Option<usize>,
    /// The state on the vertical axis of the drawing
    #[arg(long, value_name = "NAME")]
    show: Option<String>,
    /// How many threads; all cores if nothing is said
    #[arg(long, value_name = "N", value_parser = counted::<1, 4096>())]
    threads: Option<usize>,
    #[command(flatten)]
    pub(super) resume: Resume,
}

/// Reads a whole number between `LEAST` and `MOST`.
const fn counted<const LEAST: usize, const MOST: usize>() -> Reading<usize> {
    Reading(|option, word| count(option, word, [LEAST, MOST]))
}

fn sweep(option: &str, word: &str) -> Result<Sweep, Failure> {
    one_of(
        Sweep::ALL,
        Sweep::name,
        &format!("`{option}` knows no way"),
        word,
    )
}

impl Arguments {
    /// What is to be drawn.
    pub(super) fn diagram(&self, info: &ModelInfo) -> Result<Diagram, Failure> {
        Ok(Diagram {
            section: self
                .cut
                .of(info)?
                .unwrap_or_else(|| Section::usual(info.drive)),
            sweep: self.sweep,
            values: self.values,
            settle: self.settle,
            points: self.points,
            lyapunov: self.lyapunov,
            threads: self.threads,
        })
    }

    /// The state that is drawn: the one asked for, else the first that the section leaves free.
    pub(super) fn shown(&self, info: &ModelInfo, section: &Section) -> Result<usize, Failure> {
        if let Some(name) = &self.show {
            return state(info, name);
        }
        let fixed = matches!(section.surface, Surface::Level { state: 0, .. });
        Ok(usize::from(fixed && info.states.len() > 1))
    }
}

//! Arguments of `orbit`.

use clap::Args;

use crate::app::arguments::{Period, Subject};
use crate::app::harmonics::Harmonics;
use crate::app::section::Cut;

/// Find a periodic orbit and judge its stability
#[derive(Debug, Clone, Args)]
#[group(skip)]
#[command(
    after_help = "A certificate says within which radius of the start a true orbit begins; the orbit is printed without \
                  one, too, and the exit code is 1 then"
)]
pub(in crate::app) struct Arguments {
    #[command(flatten)]
    pub(super) subject: Subject,
    #[command(flatten)]
    pub(super) guess: Period,
    #[command(flatten)]
    pub(super) cut: Cut,
    #[command(flatten)]
    pub(super) harmonics: Harmonics,
    /// How near a true orbit is, by Newton and Kantorovich: a posteriori, not rigorous
    #[arg(long)]
    pub(super) certify: bool,
}

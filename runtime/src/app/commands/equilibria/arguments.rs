//! Arguments of `equilibria`.

use clap::Args;

use crate::app::arguments::{Subject, Unresumable, Way};

/// List equilibria with their eigenvalues; with --along, follow one and find its Hopf points and folds
#[derive(Debug, Clone, Args)]
#[group(skip)]
#[command(
    after_help = "With --certify, those that cannot be proven are listed with the reason, and the exit code is 1 then"
)]
pub(in crate::app) struct Arguments {
    #[command(flatten)]
    pub(super) subject: Subject,
    #[command(flatten)]
    pub(super) way: Way,
    /// Prove each with interval arithmetic: a box that holds one equilibrium, and only one
    #[arg(long)]
    pub(super) certify: bool,
    #[command(flatten)]
    pub(super) resume: Unresumable,
}

//! Arguments of `branch` for a curve.

use clap::Args;

use crate::app::values::{Range, Reading};

#[derive(Debug, Clone, Args)]
#[group(skip)]
pub(in crate::app) struct Arguments {
    /// Follow a fold, flip, torus or grazing point of the branch in this parameter too, from C to D
    #[arg(long, value_name = "NAME=C..D", value_parser = Reading(Range::read))]
    pub(super) and: Option<Range>,
    /// Which one, for instance PD1; the first without --of
    #[arg(long, value_name = "LABEL")]
    pub(super) of: Option<String>,
}

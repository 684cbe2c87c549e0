//! Arguments of `simulate`.

use clap::Args;

use crate::app::arguments::Subject;
use crate::app::section::Cut;
use crate::app::values::Reading;
use crate::app::words::positive;

/// Follow one motion from its start
#[derive(Debug, Clone, Args)]
#[group(skip)]
pub(in crate::app) struct Arguments {
    #[command(flatten)]
    pub(super) subject: Subject,
    /// How long
    #[arg(long, value_name = "T", default_value = "100", value_parser = Reading(positive))]
    pub(super) time: f64,
    #[command(flatten)]
    pub(super) cut: Cut,
}

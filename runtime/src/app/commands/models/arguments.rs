//! Arguments of `models`.

use clap::Args;

use crate::app::arguments::View;

/// Show the models, or all that is declared of one
#[derive(Debug, Clone, Args)]
#[group(skip)]
pub(in crate::app) struct Arguments {
    /// Which one
    pub(super) model: Option<String>,
    #[command(flatten)]
    pub(super) view: View,
}

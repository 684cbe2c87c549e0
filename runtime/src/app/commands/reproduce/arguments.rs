//! Arguments of `reproduce`.

use std::path::PathBuf;

use clap::Args;

#[derive(Debug, Clone, Args)]
#[group(skip)]
pub(in crate::app) struct Report {
    /// Write files to this folder, long tables row by row
    #[arg(long, value_name = "DIR", default_value = "report")]
    pub(super) out: PathBuf,
    /// Show no progress and no notes
    #[arg(long)]
    pub(super) quiet: bool,
}

/// Reproduce all tables and figures; also what happens without a command
#[derive(Debug, Clone, Args)]
#[group(skip)]
pub(in crate::app) struct Arguments {
    /// Only this part of it
    pub(super) part: Option<String>,
    #[command(flatten)]
    pub(super) report: Report,
}

impl From<Report> for Arguments {
    fn from(report: Report) -> Self {
        Self { part: None, report }
    }
}

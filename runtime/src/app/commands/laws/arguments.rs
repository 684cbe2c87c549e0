//! Arguments of `laws`.

use clap::Args;

use crate::app::arguments::{Destination, Settings};
use crate::app::failure::Failure;
use crate::app::values::Reading;
use crate::app::words::positive;
use crate::field::Smoothing;

/// Show friction laws: their formulas, and force against sliding speed
#[derive(Debug, Clone, Args)]
#[group(skip)]
#[command(
    after_help = "Of a model, the laws of its contacts are shown at its parameters and its start"
)]
pub(in crate::app) struct Arguments {
    /// A law or a model; all laws without it
    pub(super) law: Option<String>,
    #[command(flatten)]
    pub(super) settings: Settings,
    #[command(flatten)]
    pub(super) wish: Wish,
    #[command(flatten)]
    pub(super) destination: Destination,
}

/// What is said of the drawing.
#[derive(Debug, Clone, Args)]
#[group(skip)]
pub(in crate::app) struct Wish {
    /// The copy beside it, for instance tanh:50
    #[arg(long = "smooth", value_name = "KERNEL:SIZE", value_parser = Reading(smoothing))]
    pub(super) smoothing: Option<Smoothing>,
    /// The largest sliding speed, or that of a swing
    #[arg(long, value_name = "V", value_parser = Reading(positive))]
    pub(super) speed: Option<f64>,
    /// Of a swing that shows what a law remembers
    #[arg(long, value_name = "X", value_parser = Reading(positive))]
    pub(super) amplitude: Option<f64>,
}

fn smoothing(option: &str, word: &str) -> Result<Smoothing, Failure> {
    word.parse()
        .map_err(|error| Failure::usage(format!("`{option} {word}`: {error}")))
}

//! What a trade covers, and what it finds.

use serde::{Deserialize, Serialize};

use super::fit::Fit;
use crate::field::{Kernel, Smoothing, Work};
use crate::study::predict::Prediction;

/// What a trade shall cover.
#[derive(Debug, Clone, PartialEq)]
pub struct Scope {
    /// The kernels.
    pub kernels: Vec<Kernel>,
    /// Sizes of sign types, towards the exact law.
    pub sign_sizes: Vec<f64>,
    /// Sizes of bumps, towards the exact law.
    pub bump_sizes: Vec<f64>,
    /// Local tolerances of the work-precision curves; none of them if there are none.
    pub tolerances: Vec<f64>,
    /// A relative accuracy for which the cheapest setting is sought.
    pub accuracy: Option<f64>,
}

impl Default for Scope {
    /// All kernels, sign types from 1e2 to 1e7 and bumps from 1 to 1e-4 by decades, tolerances from 1e-3 to 1e-11.
    fn default() -> Self {
        Self {
            kernels: Kernel::ALL.to_vec(),
            sign_sizes: (2..=7).map(|k| 10_f64.powi(k)).collect(),
            bump_sizes: (0..=4).map(|k| 1.0 / 10_f64.powi(k)).collect(),
            tolerances: (3..=11).map(|k| 1.0 / 10_f64.powi(k)).collect(),
            accuracy: None,
        }
    }
}

/// Work and time of one period with its derivatives and extrema: what one Newton iteration pays.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Cost {
    /// Seconds, the best of a few repetitions.
    pub seconds: f64,
    /// Counted work.
    pub work: Work,
}

/// The exact orbit, against which everything is measured.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Truth {
    /// Its period.
    pub period: f64,
    /// Largest magnitude of each state.
    pub max_abs: Vec<f64>,
    /// Crossings of the section in one period.
    pub period_count: usize,
    /// Its cost at a tight tolerance.
    pub cost: Cost,
}

/// One smooth copy.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Point {
    /// The size of the smoothing.
    pub size: f64,
    /// The largest of ε φ'(0) · stick · G of all contacts that rub, and of the frequencies √(ε G) with which the copies of
    /// walls swing.
    pub stiffness: f64,
    /// Error of the frequency, relative and signed: (3.8) is its magnitude.
    pub frequency: f64,
    /// Error of the largest magnitude of each state, relative and signed: (3.7) is its magnitude.
    pub max_abs: Vec<f64>,
    /// How accurately these are measured: the size of Newton's last correction.
    pub resolution: f64,
    /// What one period of it costs at the tolerance at which it was measured.
    pub cost: Cost,
    /// What finding it cost.
    pub found: Work,
    /// The error predicted without integrating it, or why there is none.
    pub predicted: Result<Prediction, String>,
}

/// The copies of one kernel.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// The kernel.
    pub kernel: Kernel,
    /// Why the model's laws do not accept it.
    pub refused: Option<String>,
    /// The copies that have the orbit, towards the exact law.
    pub points: Vec<Point>,
    /// Sizes at which the copy has no such orbit, or none was found, and why.
    pub lost: Vec<(f64, String)>,
    /// e_f = b ε^a.
    pub frequency: Option<Fit>,
    /// The same for the largest magnitude of each state.
    pub max_abs: Vec<Option<Fit>>,
    /// The cheapest setting for the accuracy asked for, or why there is none.
    pub need: Option<Result<Need, String>>,
}

/// Error against cost of every smoothing of one model at given parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Trade {
    /// The exact orbit.
    pub exact: Truth,
    /// The kernels.
    pub curves: Vec<Curve>,
    /// Work-precision curves, the exact system first.
    pub precision: Vec<Precision>,
    /// The cheapest setting of the exact system for the accuracy asked for.
    pub need: Option<Result<Setting, String>>,
}

/// The smoothing that meets an accuracy at least cost.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Need {
    /// The copy whose frequency and extrema meet it, verified by a run.
    pub smoothing: Smoothing,
    /// The size at which its frequency alone would meet it, on the curve of the measured copies.
    pub frequency_size: f64,
    /// Its largest error by smoothing alone.
    pub error: f64,
    /// How it is integrated.
    pub setting: Setting,
}

/// How a system is integrated to meet an accuracy.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Setting {
    /// The loosest tolerance, by half decades, that does.
    pub tolerance: f64,
    /// Smoothing and integration together.
    pub error: f64,
    /// What one period costs.
    pub cost: Cost,
}

/// The work-precision curve of one system.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Precision {
    /// The copy; `None` for the exact system.
    pub smoothing: Option<Smoothing>,
    /// One point for each tolerance at which the orbit is found.
    pub points: Vec<PrecisionPoint>,
    /// Tolerances at which it is not, and why.
    pub failed: Vec<(f64, String)>,
}

impl Precision {
    /// The system's name: `exact`, or its smoothing.
    #[must_use]
    pub fn dynamics(&self) -> String {
        self.smoothing
            .map_or_else(|| "exact".to_owned(), |smoothing| smoothing.to_string())
    }
}

/// One orbit at one tolerance.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PrecisionPoint {
    /// The local tolerance.
    pub tolerance: f64,
    /// Largest relative error of period and extrema against the same system at a tight tolerance.
    #[serde(rename = "integration_error")]
    pub integration: f64,
    /// The same against the exact system: smoothing and integration together.
    #[serde(rename = "total_error")]
    pub total: f64,
    /// What one period costs.
    pub cost: Cost,
}

impl Curve {
    /// The smoothing of this curve at one size.
    #[must_use]
    pub fn at(&self, size: f64) -> Smoothing {
        Smoothing {
            kernel: self.kernel,
            size,
        }
    }
}

//! Work-precision curves: the error of integration against its cost.

use super::shoot::{Effort, Shooting, cost, near, shoot};
use super::{Cost, Scope};
use crate::field::Smoothing;
use crate::motion::Family;

/// Newton converges to this share of the tolerance.
const SHARE: f64 = 0.03;
/// Relative difference above which an orbit is another one.
const OTHER: f64 = 0.3;

/// The work-precision curve of one system.
#[derive(Debug, Clone, PartialEq)]
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
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "app", derive(serde::Serialize))]
pub struct PrecisionPoint {
    /// The local tolerance.
    pub tolerance: f64,
    /// Largest relative error of period and extrema against the same system at a tight tolerance.
    #[cfg_attr(feature = "app", serde(rename = "integration_error"))]
    pub integration: f64,
    /// The same against the exact system: smoothing and integration together.
    #[cfg_attr(feature = "app", serde(rename = "total_error"))]
    pub total: f64,
    /// What one period costs.
    pub cost: Cost,
}

/// The curve of `family` near its tight orbit.
pub(super) fn of(
    smoothing: Option<Smoothing>,
    family: &Family,
    tight: &Shooting,
    truth: &Shooting,
    scope: &Scope,
) -> Precision {
    let mut precision = Precision {
        smoothing,
        points: Vec::new(),
        failed: Vec::new(),
    };
    for &tolerance in &scope.tolerances {
        match at(family, tight, truth, tolerance) {
            Ok(point) => precision.points.push(point),
            Err(reason) => precision.failed.push((tolerance, reason)),
        }
    }
    precision
}

/// The orbit at one tolerance, or why it is not found.
pub(super) fn at(
    family: &Family,
    tight: &Shooting,
    truth: &Shooting,
    tolerance: f64,
) -> Result<PrecisionPoint, String> {
    let effort = Effort::at(tolerance, (SHARE * tolerance).max(1e-12));
    let family = family.with_tolerance(effort.tolerance);
    let guess = near(&family, 0.0, tight).map_err(|error| error.to_string())?;
    let found = shoot(&family, 0.0, &guess, effort).map_err(|error| error.to_string())?;
    let integration = found.error(tight);
    // Extrema are found no better than the tolerance, so that crossings of the section cannot be compared.
    if integration > OTHER {
        return Err(format!("it is off by {integration:.1e}: another orbit"));
    }
    Ok(PrecisionPoint {
        tolerance,
        integration,
        total: found.error(truth),
        cost: cost(&family, &found).map_err(|error| error.to_string())?,
    })
}

//! Work-precision curves: the error of integration against its cost.

use super::lost::Lost;
use super::record::{Precision, PrecisionPoint, Scope};
use super::shoot::{Effort, Shooting, cost, shoot};
use crate::field::Smoothing;
use crate::motion::Family;
use crate::shooting::Guess;

/// Newton converges to this share of the tolerance.
const SHARE: f64 = 0.03;
/// Relative difference above which an orbit is another one.
const OTHER: f64 = 0.3;

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
            Err(reason) => precision.failed.push((tolerance, reason.to_string())),
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
) -> Result<PrecisionPoint, Lost> {
    let effort = Effort::at(tolerance, (SHARE * tolerance).max(1e-12));
    let family = family.with_tolerance(effort.tolerance);
    let guess = Guess {
        place: family.at(0.0)?.place(&tight.state)?,
        ..tight.guess()
    };
    let found = shoot(&family, 0.0, &guess, effort)?;
    let integration = found.error(tight);
    // Extrema are found no better than the tolerance, so that crossings of the section cannot be compared.
    if integration > OTHER {
        return Err(Lost::Off { by: integration });
    }
    Ok(PrecisionPoint {
        tolerance,
        integration,
        total: found.error(truth),
        cost: cost(&family, &found)?,
    })
}

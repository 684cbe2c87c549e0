//! The trade near one exact orbit.

use super::accuracy;
use super::copy::Copies;
use super::precision;
use super::record::{Finding, Scope, Trade, Truth, Watch};
use super::shoot::{self, Effort};
use crate::shooting::Orbit;
use crate::study::error::TradeError;
use crate::study::question::Case;
use crate::study::system::System;

/// Measures the trade of a system near the exact `orbit` of a case; `watch` sees what is found as it is found, and may
/// end the trade there.
///
/// # Errors
/// See [`TradeError`]; a copy without the orbit is no error but part of the answer.
pub(super) fn trade(
    system: &System,
    case: &Case,
    orbit: &Orbit,
    scope: &Scope,
    watch: Watch<'_>,
) -> Result<Trade, TradeError> {
    let family = system.family(case);
    let truth = shoot::shoot(&family, 0.0, &orbit.guess(), Effort::TIGHT)?;
    let cost = shoot::cost(&family, &truth)?;
    let copies = Copies {
        system,
        case,
        orbit,
        truth: &truth,
    };
    let first = precision::of(None, &family, &truth, &truth, scope);
    let mut all = Trade {
        exact: Truth {
            period: truth.period,
            max_abs: truth.max_abs(),
            period_count: truth.count,
            cost,
        },
        curves: Vec::new(),
        precision: Vec::new(),
        need: None,
        interrupted: watch(Finding::Precision(&first)).is_break(),
    };
    all.precision.push(first);
    for &kernel in &scope.kernels {
        if !all.interrupted {
            copies.measure(kernel, scope, &mut all, watch);
        }
    }
    if let (Some(accuracy), false) = (scope.accuracy, all.interrupted) {
        all.need = Some(accuracy::cheapest(&family, &truth, &truth, accuracy));
    }
    Ok(all)
}

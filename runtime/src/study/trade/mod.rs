//! Error against cost: what each smoothing of a model with friction costs and what it gets wrong (thesis 3.2, 4.2).
//!
//! The exact orbit is the truth. Copies are found near it, followed in their size where Newton does not reach them, and
//! counted while their orbit crosses the section as often as the exact one does.

mod accuracy;
mod copy;
mod ends;
mod error;
mod fit;
mod precision;
mod record;
mod shoot;

pub use accuracy::{Need, Setting};
pub use ends::{End, TradeRecord};
pub use error::TradeError;
use error::tradable;
pub use fit::Fit;
pub use precision::{Precision, PrecisionPoint};
pub use record::{Cost, Curve, Finding, Point, Scope, Trade, Truth, worst};

use std::ops::ControlFlow;

use crate::field::{Kernel, Smoothing};
use crate::shooting::Orbit;
use crate::study::question::Case;
use crate::study::system::System;
use copy::Copies;
use shoot::{Effort, Shooting};

/// Told of each finding of a trade; a break ends it there.
pub type Watch<'a> = &'a mut dyn FnMut(Finding<'_>) -> ControlFlow<()>;

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
    let guess = shoot::guess(orbit);
    let truth = shoot::shoot(&family, 0.0, &guess, Effort::TIGHT)?;
    let cost = shoot::cost(&family, &truth)?;
    let copies = Copies {
        system,
        case,
        orbit,
        truth: &truth,
        stiffness: system.stiffness(case, &orbit.place.state),
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

impl Shooting {
    /// Relative, signed errors of frequency and largest magnitudes against `truth`.
    fn errors(&self, truth: &Self) -> (f64, Vec<f64>) {
        let pairs = self.max_abs().into_iter().zip(truth.max_abs());
        (
            truth.period / self.period - 1.0,
            pairs.map(|(a, b)| a / b - 1.0).collect(),
        )
    }

    /// The largest of them.
    fn error(&self, truth: &Self) -> f64 {
        let (frequency, max_abs) = self.errors(truth);
        max_abs
            .iter()
            .fold(frequency.abs(), |most, e| most.max(e.abs()))
    }
}

/// What a smoothing of this kernel is called at this size.
fn smoothing(kernel: Kernel, size: f64) -> Smoothing {
    Smoothing { kernel, size }
}

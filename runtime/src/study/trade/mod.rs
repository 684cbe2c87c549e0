//! Error against cost: what each smoothing of a model with friction costs and what it gets wrong (thesis 3.2, 4.2).
//!
//! The exact orbit is the truth. Copies are found near it, followed in their size where Newton does not reach them, and
//! counted while their orbit crosses the section as often as the exact one does.

mod accuracy;
mod copy;
mod fit;
mod precision;
mod shoot;

pub use accuracy::{Need, Setting};
pub use fit::Fit;
pub use precision::{Precision, PrecisionPoint};

use crate::field::exact::{ExactSystem, Mode, Modes};
use crate::field::{Kernel, Smoothing, SmoothingError, Work};
use crate::flow::{ExactFamily, FlowError};
use crate::integrate::Tolerance;
use crate::model::Model;
use crate::shooting::{Orbit, OrbitError};
use crate::study::predict::Prediction;
use copy::Copies;
use shoot::{Effort, Shooting};

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
            bump_sizes: (0..=4).map(|k| 0.1_f64.powi(k)).collect(),
            tolerances: (3..=11).map(|k| 0.1_f64.powi(k)).collect(),
            accuracy: None,
        }
    }
}

/// Work and time of one period with its derivatives and extrema: what one Newton iteration pays.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Cost {
    /// Counted work.
    pub work: Work,
    /// Seconds, the best of a few repetitions.
    pub seconds: f64,
}

/// The exact orbit, against which everything is measured.
#[derive(Debug, Clone, PartialEq)]
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
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// The size of the smoothing.
    pub size: f64,
    /// ε φ'(0) · stick · G, the largest of all contacts.
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
    pub refused: Option<SmoothingError>,
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

/// Why there is no trade.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum TradeError {
    /// The model has no contact.
    #[error("`{model}` has no friction: there is nothing to trade")]
    NoFriction {
        /// The model.
        model: &'static str,
    },
    /// The exact orbit cannot be shot again.
    #[error("the exact orbit cannot be reproduced: {0}")]
    Orbit(#[from] OrbitError),
    /// The exact motion cannot be followed.
    #[error(transparent)]
    Flow(#[from] FlowError),
}

/// Measures the trade of `model` near its exact `orbit`.
///
/// # Errors
/// See [`TradeError`]; a copy without the orbit is no error but part of the answer.
pub fn trade<M: Model<N>, const N: usize>(
    model: &M,
    orbit: &Orbit<N, Modes<M, N>>,
    scope: &Scope,
) -> Result<Trade, TradeError> {
    if M::INFO.contacts.is_empty() {
        return Err(TradeError::NoFriction {
            model: M::INFO.command,
        });
    }
    let family = ExactFamily {
        model: *model,
        design: None,
        tolerance: Tolerance::for_accuracy(1e-11),
        magnitude: [1.0; N],
    };
    let guess = shoot::guess(orbit);
    let truth = shoot::shoot(&family, 0.0, &guess, Effort::TIGHT)?;
    let cost = shoot::cost(&family, &truth)?;
    let copies = Copies {
        model,
        orbit,
        truth: &truth,
        stiffness: stiffness(model, &orbit.place.state),
    };
    let mut curves = Vec::new();
    let mut precision = vec![precision::of(None, &family, &truth, &truth, scope)];
    for &kernel in &scope.kernels {
        let (mut curve, found) = copies.curve(kernel, scope);
        for (smoothing, copy) in &found {
            let family = copies.family(*smoothing, Effort::TIGHT.tolerance);
            precision.push(precision::of(
                Some(*smoothing),
                &family,
                copy,
                &truth,
                scope,
            ));
        }
        if let Some(accuracy) = scope.accuracy
            && curve.refused.is_none()
        {
            curve.need = Some(copies.need(&curve, &found, accuracy));
        }
        curves.push(curve);
    }
    let need = scope
        .accuracy
        .map(|accuracy| accuracy::cheapest(&family, &truth, &truth, accuracy));
    Ok(Trade {
        exact: Truth {
            period: truth.period,
            max_abs: truth.max_abs().to_vec(),
            period_count: truth.count,
            cost,
        },
        curves,
        precision,
        need,
    })
}

/// Of trades at several parameters, the one at whose parameters a kernel needs most: the worst end of a range.
#[must_use]
pub fn worst(trades: &[Trade], kernel: Kernel) -> Option<(usize, &Result<Need, String>)> {
    let needs = trades.iter().enumerate().filter_map(|(end, trade)| {
        let curve = trade.curves.iter().find(|curve| curve.kernel == kernel)?;
        Some((end, curve.need.as_ref()?))
    });
    let demand = |need: &Result<Need, String>| match need {
        Ok(need) => need.smoothing.sharpness(),
        Err(_) => f64::INFINITY,
    };
    needs.reduce(|a, b| if demand(b.1) > demand(a.1) { b } else { a })
}

/// stick · G of each contact at `state`; the largest.
fn stiffness<M: Model<N>, const N: usize>(model: &M, state: &[f64; N]) -> f64 {
    let system = ExactSystem::new(model, None);
    let affine = system.affine(state, &Modes::from_fn(|_| Mode::Stick));
    let of = |i: usize| affine.compliance.as_ref()[i].as_ref()[i] * affine.stick.as_ref()[i];
    (0..M::INFO.contacts.len()).map(of).fold(0.0, f64::max)
}

impl<const N: usize> Shooting<N> {
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

//! Exact motions of models at their own parameters.

use stickslip::flow::ExactFamily;
use stickslip::integrate::Tolerance;
use stickslip::model::Model;
use stickslip::shooting::{Orbit, OrbitError, Search, closest};
use stickslip::study::trade::{Scope, Trade};
use stickslip::study::{Case, Dynamics, StudyError, System};

/// The exact flows of a model, for results of this relative accuracy.
#[must_use]
pub fn family<M: Model<N>, const N: usize>(model: M, accuracy: f64) -> ExactFamily<M, N> {
    ExactFamily {
        model,
        design: None,
        tolerance: Tolerance::for_accuracy(accuracy),
        magnitude: [1.0; N],
    }
}

/// What is asked of the search for an orbit from this start.
#[must_use]
pub fn search(start: &[f64], accuracy: f64) -> Search {
    Search {
        start: start.to_vec(),
        modes: Vec::new(),
        period: None,
        accuracy,
        segments: 1,
    }
}

/// The exact orbit that is reached from this start.
///
/// # Errors
/// There is none.
pub fn orbit<M: Model<N>, const N: usize>(
    model: M,
    start: [f64; N],
    accuracy: f64,
) -> Result<Orbit, OrbitError> {
    let family = family(model, accuracy).into();
    closest(&family, 0.0, &search(&start, accuracy))
}

/// The question to a model as it is, from this start.
#[must_use]
pub fn case<M: Model<N>, const N: usize>(model: &M, start: [f64; N]) -> Case {
    Case {
        parameters: model.values().as_ref().to_vec(),
        start: Some(start.to_vec()),
        ..Case::declared(M::INFO, Dynamics::Exact)
    }
}

/// What the copies of a model's exact orbit cost and get wrong.
///
/// # Errors
/// There is no such orbit, or nothing to copy.
pub fn trade<M: Model<N>, const N: usize>(
    model: M,
    start: [f64; N],
    scope: &Scope,
) -> Result<Trade, StudyError> {
    let (system, case) = (System::of::<M, N>(), case(&model, start));
    let mut record = system.trade(&case, scope)?;
    Ok(record.ends.remove(0).trade)
}

//! DOP853: the explicit method of order 8 for stretches that are not stiff.
//!
//! [`Stepper`] makes one step at a time, so that its owner can look inside a step, shorten it to an
//! event, and go on; [`integrate`] is the plain loop above it.

use std::ops::ControlFlow;

use super::carried::Carried;
pub use super::stepper::Stepper;
use super::{IntegrationError, Tolerance};
use crate::field::{Field, Work};

/// How an explicit integration is run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// What the local error of the state is measured against.
    pub tolerance: Tolerance,
    /// Trial steps after which to give up.
    pub steps: u64,
    /// Steps at the edge of stability after which the problem is called stiff.
    pub stiff_steps: u32,
    /// Whether it goes on at the edge of stability where the steps that are left suffice for the whole span at their
    /// present length.
    pub persists: bool,
}

impl Settings {
    /// The usual limits with this tolerance.
    #[must_use]
    pub fn new(tolerance: Tolerance) -> Self {
        Self {
            tolerance,
            steps: 100_000,
            stiff_steps: 15,
            persists: false,
        }
    }
}

/// Integrates from `from` for the time `span` ≥ 0; `observe` sees every step before it is committed
/// and may stop the integration there.
///
/// # Errors
/// Those of [`Stepper::attempt`]; whatever was counted until then is in `work` too.
pub fn integrate<F: Field<N>, V: Carried<N>, const N: usize>(
    field: &F,
    settings: Settings,
    from: V,
    span: f64,
    work: &mut Work,
    mut observe: impl FnMut(&mut Stepper<'_, F, V, N>) -> ControlFlow<()>,
) -> Result<V, IntegrationError> {
    let mut stepper = Stepper::new(field, settings, from, 0.0, span);
    stepper.check_start()?;
    let mut outcome = Ok(());
    while outcome.is_ok() && stepper.time() < span {
        outcome = stepper
            .attempt(span - stepper.time())
            .and_then(|()| stepper.stop_at_corner());
        if outcome.is_ok() {
            let stop = observe(&mut stepper).is_break();
            // What is left may round to less than the time can resolve.
            let last = stepper.time() + stepper.length() >= span;
            stepper.commit();
            if stop || last {
                break;
            }
        }
    }
    *work += stepper.work;
    outcome.map(|()| *stepper.from())
}

#[cfg(test)]
mod tests;

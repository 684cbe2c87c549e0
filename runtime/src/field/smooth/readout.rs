//! What a smooth motion shows besides its states: friction forces and observables.

use super::{SmoothField, Smoothed};
use crate::friction::{ContactRule, FrictionLaw};
use crate::model::Model;
use crate::press::PressLaw;
use crate::scalar::Inline;

impl<M: Model<N>, const N: usize> SmoothField<M, N> {
    /// The values of the parameters.
    pub(crate) fn values(&self) -> &M::Params<f64> {
        &self.values
    }

    /// The friction force of each contact at `y`.
    #[must_use]
    pub fn forces(&self, y: &[f64; N]) -> M::PerContact<f64> {
        let mut recording = Recording::<M, N> {
            rule: self.rule,
            forces: Inline::from_fn(|_| 0.0),
        };
        let _ = M::rhs(&self.values, *y, &mut recording);
        recording.forces
    }

    /// The value of each `let` line at `y`.
    #[must_use]
    pub fn observables(&self, y: &[f64; N]) -> M::Observables {
        M::observables(&self.values, *y, &mut { self.rule })
    }
}

/// Notes each force on its way into the equations.
struct Recording<M: Model<N>, const N: usize> {
    rule: Smoothed<f64>,
    forces: M::PerContact<f64>,
}

impl<M: Model<N>, const N: usize> ContactRule<f64> for Recording<M, N> {
    fn force<L: FrictionLaw<f64>>(&mut self, contact: usize, law: &L, speed: f64) -> f64 {
        let force = self.rule.force(contact, law, speed);
        if let Some(place) = self.forces.as_mut().get_mut(contact) {
            *place = force;
        }
        force
    }

    fn press<L: PressLaw<f64>>(&mut self, contact: usize, law: &L, gap: f64, rate: f64) -> f64 {
        let force = self.rule.press(contact, law, gap, rate);
        if let Some(place) = self.forces.as_mut().get_mut(contact) {
            *place = force;
        }
        force
    }
}

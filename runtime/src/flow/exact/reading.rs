//! Forces and observables at a place of an exact motion: what holds a sticking contact is read off the equations.

use super::ExactFlow;
use crate::field::exact::Modes;
use crate::flow::{FlowError, Place};
use crate::friction::{ContactRule, FrictionLaw};
use crate::model::Model;
use crate::press::PressLaw;

impl<M: Model<N>, const N: usize> ExactFlow<M, N> {
    /// The forces of all contacts and `let` lines.
    pub(crate) fn reading(
        &self,
        at: &Place<N, Modes<M, N>>,
    ) -> Result<(Vec<f64>, Vec<f64>), FlowError> {
        let contacts = self.system.contact_states(&at.state, &at.mode)?;
        let forces: Vec<f64> = contacts.as_ref().iter().map(|c| c.force).collect();
        let observables = M::observables(self.system.values(), at.state, &mut Given(&forces));
        let observables = observables.as_ref().to_vec();
        Ok((forces, observables))
    }
}

/// Forces that are known already.
struct Given<'a>(&'a [f64]);

impl ContactRule<f64> for Given<'_> {
    fn force<L: FrictionLaw<f64>>(&mut self, contact: usize, _law: &L, _speed: f64) -> f64 {
        self.0.get(contact).copied().unwrap_or(0.0)
    }

    fn press<L: PressLaw<f64>>(&mut self, contact: usize, _law: &L, _gap: f64, _rate: f64) -> f64 {
        self.0.get(contact).copied().unwrap_or(0.0)
    }
}

//! Contacts whose friction has no effect where they are, as at the dead centre of a crank: nothing holds them there.

use super::settle::Rest;
use crate::field::exact::{Mode, Modes, Snapshot};
use crate::flow::FlowError;
use crate::model::Model;
use crate::scalar::Inline;
use num_dual::Dual64;

/// Share of its usual size by which a state is moved to see where a speed goes.
const AHEAD: f64 = 1e-3;

impl<M: Model<N>, const N: usize> Rest<'_, M, N> {
    /// Takes such contacts from those at rest: each goes on as its speed does. Of each that is taken the order of the lowest
    /// derivative of w that does not vanish, 0 of the others.
    ///
    /// # Errors
    /// Forces of others that are not unique.
    pub(super) fn pass_dead_centres(&mut self) -> Result<M::PerContact<usize>, FlowError> {
        let mut orders: M::PerContact<usize> = Inline::from_fn(|_| 0);
        let without = self.without_effect();
        if without.is_empty() {
            return Ok(orders);
        }
        let mut modes = self.all_stick();
        for &i in &without {
            modes.set(i, Mode::Loose);
        }
        let ways = self.ways(&modes)?;
        for i in without {
            let (order, way) = ways.as_ref()[i];
            self.resting.as_mut()[i] = false;
            self.before.set(i, Mode::sliding(way));
            orders.as_mut()[i] = order;
        }
        Ok(orders)
    }

    /// The contacts at rest whose force changes no state.
    fn without_effect(&self) -> Vec<usize> {
        // What is constant has been judged where the motion was set up.
        if self.system.gradients().is_some() || self.contacts().next().is_none() {
            return Vec::new();
        }
        let affine = self.system.affine(&self.state, &self.all_stick());
        let acts = |i: &usize| affine.input.as_ref()[*i].iter().any(|b| *b != 0.0);
        self.contacts().filter(|i| !acts(i)).collect()
    }

    /// For each contact the order of the first derivative of w that does not vanish, up to the third, and that derivative
    /// or a number of its sign.
    fn ways(&self, modes: &Modes<M, N>) -> Result<M::PerContact<(usize, f64)>, FlowError> {
        let moving = self.system.moving(&self.state, modes)?;
        let second = self.system.second_rates(&self.state, modes, &moving.field);
        let third = self.system.speeds(&self.ahead(&moving));
        Ok(Inline::from_fn(|i| {
            let (rate, bend) = (moving.speed.as_ref()[i].eps, second.as_ref()[i]);
            if rate != 0.0 {
                (1, rate)
            } else if bend != 0.0 {
                (2, bend)
            } else {
                (3, third.as_ref()[i])
            }
        }))
    }

    /// The state a little later, to second order.
    fn ahead(&self, moving: &Snapshot<M, Dual64, N>) -> [f64; N] {
        let fastest = (0..N).fold(0.0_f64, |most, j| {
            let size = self.system.magnitude[j] + self.state[j].abs();
            let (rate, bend) = (moving.field[j].re / size, moving.field[j].eps / size);
            most.max(rate.abs()).max(bend.abs().sqrt())
        });
        let time = if fastest > 0.0 { AHEAD / fastest } else { 0.0 };
        std::array::from_fn(|j| {
            self.state[j] + time * (moving.field[j].re + 0.5 * time * moving.field[j].eps)
        })
    }
}

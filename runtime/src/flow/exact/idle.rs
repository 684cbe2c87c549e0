//! Contacts at rest that their friction cannot hold: at the dead centre of a crank it changes no state, and what a moving wall
//! leads has the speed of the wall, whatever rubs on it.

use num_dual::Dual64;

use super::settle::Rest;
use crate::field::exact::{Mode, Modes, Snapshot};
use crate::flow::FlowError;
use crate::model::Model;
use crate::scalar::Inline;

/// Share of its usual size by which a state is moved to see where a speed goes.
const AHEAD: f64 = 1e-3;
/// Share of what friction does to a speed that presses at rest leave of it, where that is rounding error.
const NOTHING: f64 = 1e-10;
/// Rate of a speed, relative to what friction could do, below which the next derivative decides.
const NO_RATE: f64 = 1e-12;

impl<M: Model<N>, const N: usize> Rest<'_, M, N> {
    /// Takes such contacts from those at rest: each goes on as its speed does. Of each that is taken the order of the lowest
    /// derivative of w that does not vanish, 0 of the others.
    ///
    /// # Errors
    /// Forces of others that are not unique.
    pub(super) fn pass_idle(&mut self) -> Result<M::PerContact<usize>, FlowError> {
        let mut orders: M::PerContact<usize> = Inline::from_fn(|_| 0);
        let all = self.all_stick();
        let idle = self.idle(&all);
        if idle.is_empty() {
            return Ok(orders);
        }
        let mut modes = all;
        for &i in &idle {
            modes.set(i, Mode::Loose);
        }
        let ways = self.ways(&modes, &all)?;
        for i in idle {
            let (order, way) = ways.as_ref()[i];
            self.resting.as_mut()[i] = false;
            self.before.set(i, Mode::sliding(way));
            orders.as_mut()[i] = order;
        }
        Ok(orders)
    }

    /// The contacts at rest that their friction cannot hold.
    fn idle(&self, all: &Modes<M, N>) -> Vec<usize> {
        // What is constant has been judged where the motion was set up; what presses lead has not.
        let constant = self.system.gradients().is_some();
        let leads = all.resting().next().is_some();
        if (constant && !leads) || self.contacts().next().is_none() {
            return Vec::new();
        }
        let affine = self.system.affine(&self.state, all);
        let acts = |i: usize| affine.input.as_ref()[i].iter().any(|b| *b != 0.0);
        self.contacts()
            .filter(|i| !acts(*i) || self.is_led(*i, all))
            .collect()
    }

    /// Whether a press at rest makes up for all that the force of a contact would do to its speed.
    fn is_led(&self, contact: usize, all: &Modes<M, N>) -> bool {
        all.resting().any(|press| {
            let mut pair = Modes::resting_alone(press);
            pair.set(contact, Mode::Stick);
            let able = self.system.affine(&self.state, &pair);
            let entry = |i: usize, j: usize| able.compliance.as_ref()[i].as_ref()[j];
            let own = entry(contact, contact) * entry(press, press);
            let left = own - entry(contact, press) * entry(press, contact);
            !self.system.is_tied(contact, press) && left.abs() <= NOTHING * own.abs()
        })
    }

    /// For each contact the order of the first derivative of w that does not vanish, up to the third, and that derivative
    /// or a number of its sign.
    fn ways(
        &self,
        modes: &Modes<M, N>,
        all: &Modes<M, N>,
    ) -> Result<M::PerContact<(usize, f64)>, FlowError> {
        let moving = self.system.moving(&self.state, modes)?;
        let second = self.system.second_rates(&self.state, modes, &moving.field);
        let third = self.system.speeds(&self.ahead(&moving));
        let able = self.system.affine(&self.state, all);
        Ok(Inline::from_fn(|i| {
            let (rate, bend) = (moving.speed.as_ref()[i].eps, second.as_ref()[i]);
            let could = able.compliance.as_ref()[i].as_ref()[i] * able.stick.as_ref()[i];
            if rate.abs() > NO_RATE * could {
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
        crate::scalar::filled(|j| {
            self.state[j] + time * (moving.field[j].re + 0.5 * time * moving.field[j].eps)
        })
    }
}

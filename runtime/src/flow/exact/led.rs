//! Friction on what a moving wall leads: its speed is that of the wall, which it cannot stop.

use super::settle::Rest;
use crate::field::exact::{Mode, Modes};
use crate::flow::FlowError;
use crate::model::Model;

/// Share of what friction does to a speed that presses at rest leave of it, where that is rounding error.
const NOTHING: f64 = 1e-10;
/// Rate of a speed, relative to what friction can do, below which the next derivative decides.
const NO_RATE: f64 = 1e-12;

impl<M: Model<N>, const N: usize> Rest<'_, M, N> {
    /// Lets contacts go on as presses at rest lead them, and tells them with the order of the derivative of w that decides
    /// in which way.
    ///
    /// # Errors
    /// The forces are not determined without them.
    pub(super) fn lead(&mut self) -> Result<Vec<(usize, usize)>, FlowError> {
        let all = self.all_stick();
        let led: Vec<usize> = self.contacts().filter(|i| self.is_led(*i, &all)).collect();
        if led.is_empty() {
            return Ok(Vec::new());
        }
        let free = Modes::from_fn(|i| match led.contains(&i) {
            true => Mode::Loose,
            false => all.as_slice()[i],
        });
        let moving = self.system.moving(&self.state, &free)?;
        let bends = self.system.second_rates(&self.state, &free, &moving.field);
        let able = self.system.affine(&self.state, &all);
        let mut orders = Vec::new();
        for i in led {
            let rate = moving.speed.as_ref()[i].eps;
            let scale = able.compliance.as_ref()[i].as_ref()[i] * able.stick.as_ref()[i];
            let flat = rate.abs() <= NO_RATE * scale;
            let way = if flat { bends.as_ref()[i] } else { rate };
            self.before.set(i, Mode::sliding(way));
            self.resting.as_mut()[i] = false;
            orders.push((i, if flat { 2 } else { 1 }));
        }
        Ok(orders)
    }

    /// Whether a press at rest makes up for all that the force of a contact would do to its speed.
    fn is_led(&self, contact: usize, all: &Modes<M, N>) -> bool {
        all.resting().any(|press| {
            let pair = Modes::from_fn(|i| match i {
                i if i == contact => Mode::Stick,
                i if i == press => Mode::Rest,
                i if i < M::INFO.contacts.len() => Mode::Loose,
                _ => Mode::Open,
            });
            let able = self.system.affine(&self.state, &pair);
            let entry = |i: usize, j: usize| able.compliance.as_ref()[i].as_ref()[j];
            let own = entry(contact, contact) * entry(press, press);
            let left = own - entry(contact, press) * entry(press, contact);
            !self.system.is_tied(contact, press) && left.abs() <= NOTHING * own.abs()
        })
    }
}

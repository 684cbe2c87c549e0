//! What contacts hold between them that stick at once and act on each other's speeds, or read the same states.

use super::constants::Constants;
use super::error::{ContactError, singular};
use super::mode::Modes;
use crate::field::Strip;
use crate::model::Model;
use crate::scalar::Inline;

/// What contacts that stick hold together.
pub(super) struct Together<M: Model<N>, const N: usize> {
    /// B_S G_SS⁻¹ column by column.
    pub(super) levers: M::PerContact<Strip<N>>,
    /// What holds, in front: w_y and lever of each that sticks, f = f₀ − Σ lever (w_y f₀).
    pub(super) holds: M::PerContact<[Strip<N>; 2]>,
}

impl<M: Model<N>, const N: usize> Constants<M, N> {
    /// What contacts that stick hold together, if they do: where each has its way, nothing but its own constants are asked.
    ///
    /// # Errors
    /// G_SS is singular.
    pub(super) fn together(
        &self,
        modes: &Modes<M, N>,
    ) -> Result<Option<Box<Together<M, N>>>, ContactError> {
        let coupled = |i: usize| self.coupled.as_ref()[i];
        if !self.braced && !modes.sticking().any(coupled) {
            return Ok(None);
        }
        let levers = self.levers(modes).ok_or_else(|| singular(modes))?;
        let holds = self.holds(modes, &levers);
        Ok(Some(Box::new(Together { levers, holds })))
    }

    /// B_S G_SS⁻¹ column by column for the contacts that stick; `None` if G_SS is singular.
    fn levers(&self, modes: &Modes<M, N>) -> Option<M::PerContact<Strip<N>>> {
        let mut levers: M::PerContact<Strip<N>> = Inline::from_fn(|_| Strip::ZERO);
        for column in modes.sticking() {
            let unit = Inline::from_fn(|i| f64::from(i == column));
            let push = self.respond::<f64>(modes, unit)?;
            let mut lever = [0.0; N];
            for row in modes.sticking() {
                self.input.as_ref()[row].add_to(&mut lever, push.as_ref()[row]);
            }
            let own = self.gradient.as_ref()[column].only();
            for state in self.still(modes).filter(|state| Some(*state) != own) {
                lever[state] = 0.0;
            }
            levers.as_mut()[column] = lever.into();
        }
        Some(levers)
    }

    /// w_y and lever of what holds, in front: of each contact that sticks, or of each state that these hold between them.
    fn holds(
        &self,
        modes: &Modes<M, N>,
        levers: &M::PerContact<Strip<N>>,
    ) -> M::PerContact<[Strip<N>; 2]> {
        let mut holds = Inline::from_fn(|_| [Strip::ZERO; 2]);
        let places: &mut [_] = M::PerContact::as_mut(&mut holds);
        if let Some(held) = self.held(modes) {
            let states = (0..N).filter(|state| held[*state]);
            for (place, state) in places.iter_mut().zip(states) {
                *place = self.brace_of(state, &held, modes, levers);
            }
        } else {
            for (place, contact) in places.iter_mut().zip(modes.sticking()) {
                *place = [self.gradient.as_ref()[contact], levers.as_ref()[contact]];
            }
        }
        holds
    }

    /// Gradient and lever of a state that contacts hold between them: of L G, their levers and gradients, nothing is left of
    /// such states but itself.
    fn brace_of(
        &self,
        state: usize,
        held: &[bool; N],
        modes: &Modes<M, N>,
        levers: &M::PerContact<Strip<N>>,
    ) -> [Strip<N>; 2] {
        let mut unit = [0.0; N];
        unit[state] = 1.0;
        let mut lever = [0.0; N];
        for contact in modes.sticking() {
            let share = self.gradient.as_ref()[contact].entries()[state];
            levers.as_ref()[contact].add_to(&mut lever, share);
        }
        for other in (0..N).filter(|other| held[*other]) {
            lever[other] = unit[other];
        }
        [unit.into(), lever.into()]
    }
}

//! How a motion begins: on surfaces or off them, sticking or departing.

use super::ExactFlow;
use super::press::Vanishing;
use super::run::Run;
use super::settle::Rest;
use super::switch::ROUNDING;
use crate::field::exact::{Mode, Modes};
use crate::flow::{FlowError, Place};
use crate::model::Model;
use crate::scalar::Inline;

/// Distance on the wrong side of its surface, relative to its scale, from which a motion may still depart.
const WRONG_SIDE: f64 = 1e-6;

impl<M: Model<N>, const N: usize> ExactFlow<M, N> {
    /// Whether what sticks in these modes does not move, but for what a motion may be off its surface.
    pub(crate) fn is_still(&self, at: &Place<N, Modes<M, N>>) -> bool {
        let (speeds, scales) = (self.system.speeds(&at.state), self.speed_scales(&at.state));
        at.mode.bound().all(|i| {
            let scale = scales.as_ref()[i].max(self.system.usual_speed(i));
            speeds.as_ref()[i].abs() <= WRONG_SIDE * scale
        })
    }
}

impl<M: Model<N>, const N: usize> Run<'_, M, N> {
    /// Decides how the motion begins: on surfaces or off them, sticking or departing.
    pub(super) fn depart(&mut self) -> Result<(), FlowError> {
        self.put_on_surface()?;
        let state = *self.carried.state();
        self.flow.check_gaps(&state, &self.modes, self.time)?;
        let rounded = |_| Some(Vanishing::Rounded);
        let presses = self.flow.with_presses(&state, self.modes, &rounded)?;
        let speeds = self.flow.system.speeds(&state);
        let scales = self.flow.speed_scales(&state);
        let mut resting: M::PerContact<bool> = Inline::from_fn(|_| false);
        let modes = presses.modes.as_slice().iter().enumerate();
        for (i, mode) in modes.filter(|(i, mode)| mode.rubs() && !self.flow.system.is_idle(*i)) {
            let speed = speeds.as_ref()[i];
            // Against fixed ground a speed is its own only term: what is usual then tells rounding errors.
            let scale = scales.as_ref()[i].max(self.flow.system.usual_speed(i));
            if *mode != Mode::Stick && mode.sign() * speed < -WRONG_SIDE * scale {
                return Err(FlowError::InconsistentMode {
                    contact: M::INFO.contact_id(i),
                    time: self.time,
                    mode: *mode,
                    speed,
                    rate: 0.0,
                    second_rate: 0.0,
                });
            }
            resting.as_mut()[i] = mode.sign() * speed <= ROUNDING * scale;
        }
        let rest = |before: Modes<M, N>| {
            let still = |i: usize| resting.as_ref()[i] && before.as_slice()[i].rubs();
            Rest {
                system: &self.flow.system,
                arrival: self.flow.arrival,
                state,
                time: self.time,
                before: Modes::from_fn(|i| match before.as_slice()[i] {
                    _ if still(i) => Mode::Stick,
                    mode => mode,
                }),
                resting: Inline::from_fn(still),
                let_go: Inline::from_fn(|i| match still(i) {
                    true => before.as_slice()[i].sign(),
                    false => 0.0,
                }),
            }
        };
        let verdict = self.flow.borne(&state, self.time, &presses, &rest)?;
        self.take(&verdict, &Inline::from_fn(|_| 0.0))
    }
}

//! The exact field with the copy's friction as a virtual design variable: its derivative is what the copy adds.

use crate::field::exact::{ContactError, ExactField, ExactSystem, Mode, Modes};
use crate::field::{Field, Linear, Smoothed, Smoothing};
use crate::friction::{ContactRule, FrictionLaw};
use crate::model::Model;
use crate::scalar::Inline;

use super::layer::creep;

/// Step along the motion, in units of the layer's own time, over which levers are compared.
const NUDGE: f64 = 1e-6;

/// The exact field in one mode; "∂f/∂r" is the first-order effect of the copy.
pub(super) struct VirtualField<'s, M: Model<N>, const N: usize> {
    system: &'s ExactSystem<M, N>,
    field: ExactField<'s, M, N>,
    modes: Modes<M, N>,
    smoothing: Smoothing,
    /// Where creep ends, for each contact, in units of the layer; 0 leaves creep out.
    caps: M::PerContact<f64>,
    /// Whether the force that a sliding contact still lacks is counted.
    tails: M::PerContact<bool>,
}

impl<'s, M: Model<N>, const N: usize> VirtualField<'s, M, N> {
    pub(super) fn new(
        system: &'s ExactSystem<M, N>,
        smoothing: Smoothing,
        modes: Modes<M, N>,
        state: &[f64; N],
        caps: impl Fn(usize) -> f64,
        tails: impl Fn(usize) -> bool,
    ) -> Result<Self, ContactError> {
        Ok(Self {
            system,
            field: ExactField::new(system, modes, state)?,
            modes,
            smoothing,
            caps: Inline::from_fn(caps),
            tails: Inline::from_fn(tails),
        })
    }

    /// The speeds with which the copy creeps where the exact contacts stick.
    pub(super) fn creep(&self, y: &[f64; N]) -> M::PerContact<f64> {
        let still = Inline::from_fn(|_| 0.0);
        let Ok(at) = self.system.snapshot(y, &self.modes) else {
            return still;
        };
        let limits = self.system.limits_at_rest(y);
        let mut speeds = still;
        for i in self.modes.sticking() {
            let (force, stick) = (at.force.as_ref()[i], at.stick.as_ref()[i]);
            let slip = limits.as_ref()[i].1;
            speeds.as_mut()[i] = creep(&self.smoothing, force, stick, slip, self.caps.as_ref()[i]);
        }
        speeds
    }

    /// The smallest change of the state that changes the sticking contacts' speeds by these.
    pub(super) fn lift(&self, y: &[f64; N], speeds: &M::PerContact<f64>) -> [f64; N] {
        self.field.correction(y, speeds)
    }

    /// The rates of the sticking contacts' speeds when the state moves along `direction`.
    pub(super) fn rates(&self, y: &[f64; N], direction: &[f64; N]) -> M::PerContact<f64> {
        self.system.rates_along(y, &self.modes, direction)
    }

    /// What the forces that sliding contacts still lack add to the field, sticking contacts held.
    fn lacking(&self, y: &[f64; N]) -> [f64; N] {
        if !self.tails.as_ref().contains(&true) {
            return [0.0; N];
        }
        let values = self.system.values();
        let with = M::rhs(values, *y, &mut self.lack(self.tails));
        let without = M::rhs(values, *y, &mut self.lack(Inline::from_fn(|_| false)));
        let push: [f64; N] = std::array::from_fn(|j| with[j] - without[j]);
        let held = self.lift(y, &self.rates(y, &push));
        std::array::from_fn(|j| push[j] - held[j])
    }

    fn lack(&self, tails: M::PerContact<bool>) -> Lack<M, N> {
        Lack {
            modes: self.modes,
            tails,
            copy: Smoothed {
                kernel: self.smoothing.kernel,
                sharpness: self.smoothing.sharpness(),
            },
        }
    }

    /// d/dt of the lift of given speeds: what moving levers add while the contacts creep.
    fn lever_rate(
        &self,
        y: &[f64; N],
        velocity: &[f64; N],
        speeds: &M::PerContact<f64>,
    ) -> [f64; N] {
        let at = |h: f64| {
            let moved = std::array::from_fn(|j| y[j] + h * velocity[j]);
            self.lift(&moved, speeds)
        };
        let (ahead, behind) = (at(NUDGE), at(-NUDGE));
        std::array::from_fn(|j| (ahead[j] - behind[j]) / (2.0 * NUDGE))
    }
}

impl<M: Model<N>, const N: usize> Field<N> for VirtualField<'_, M, N> {
    const KINEMATIC: [Option<usize>; N] = M::KINEMATIC;

    fn f(&self, y: &[f64; N]) -> [f64; N] {
        self.field.f(y)
    }

    /// With δy = q + L c, where L c lifts the creep c, q obeys q̇ = f_y (q + L c) − L̇ c + lacking forces.
    fn linearise(&self, y: &[f64; N]) -> Linear<N> {
        let mut linear = self.field.linearise(y);
        linear.design = self.lacking(y);
        if self.field.sticks() {
            let speeds = self.creep(y);
            let lifted = self.lift(y, &speeds);
            let turning = self.lever_rate(y, &linear.f, &speeds);
            for (i, entry) in linear.design.iter_mut().enumerate() {
                let row = linear.jacobian[i].iter().zip(&lifted);
                *entry += row.map(|(j, l)| j * l).sum::<f64>() - turning[i];
            }
        }
        linear
    }
}

/// The copy's force less the exact one where a contact slides and that is asked for; else none.
struct Lack<M: Model<N>, const N: usize> {
    modes: Modes<M, N>,
    tails: M::PerContact<bool>,
    copy: Smoothed<f64>,
}

impl<M: Model<N>, const N: usize> ContactRule<f64> for Lack<M, N> {
    fn force<L: FrictionLaw<f64>>(&mut self, contact: usize, law: &L, speed: f64) -> f64 {
        let mode = self.modes.as_slice()[contact];
        if mode == Mode::Stick || !self.tails.as_ref()[contact] {
            return 0.0;
        }
        self.copy.force(contact, law, speed) + mode.sign() * law.slip(speed.abs())
    }
}

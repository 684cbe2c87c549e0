//! The exact field: every contact slides one way or sticks, and a sticking force is what keeps its speed at zero.

mod affine;
mod constants;
mod mode;
mod rule;
mod solve;

use num_dual::Dual64;

use super::{Field, Linear};
use crate::model::Model;
use crate::scalar::{Inline, Lanes, Scalar};
use affine::speed_rates;
pub(crate) use affine::{Affine, Snapshot};
use constants::Constants;
pub use mode::{Mode, Modes};
use rule::Branches;

/// Why the forces at rest are not determined.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ContactError {
    /// Several contacts resist the same motion, or a force does not act on any speed.
    #[error(
        "the sticking forces of contacts {contacts:?} are not unique: their compliance matrix is singular"
    )]
    Singular {
        /// Numbers of the contacts that would stick together.
        contacts: Vec<usize>,
    },
    /// G_ii ≤ 0: a sign error in the model.
    #[error(
        "the force of contact {contact} does not oppose its speed: a unit force changes it at the rate {compliance:e}"
    )]
    NotOpposing {
        /// Number of the contact.
        contact: usize,
        /// G_ii, which should be positive.
        compliance: f64,
    },
}

/// A model at given parameters, its parameters lifted once to every scalar in use.
pub struct ExactSystem<M: Model<N>, const N: usize> {
    plain: M::Params<f64>,
    directional: M::Params<Dual64>,
    lanes: M::Params<M::Lanes>,
    constants: Option<Constants<M, N>>,
}

impl<M: Model<N>, const N: usize> ExactSystem<M, N> {
    /// The model with the parameter of index `design`, if any, as design variable.
    #[must_use]
    pub fn new(model: &M, design: Option<usize>) -> Self {
        let plain = model.values();
        let values = plain.as_ref();
        let lanes = Inline::from_fn(|i| M::Lanes::design(values[i], f64::from(design == Some(i))));
        Self {
            plain,
            directional: Inline::from_fn(|i| Dual64::from(values[i])),
            constants: Constants::find(&lanes),
            lanes,
        }
    }

    /// Number of contacts.
    #[must_use]
    pub fn contacts(&self) -> usize {
        M::INFO.contacts.len()
    }

    /// w_y of each contact, if none depends on the state.
    pub(crate) fn gradients(&self) -> Option<&[[f64; N]]> {
        self.constants.as_ref().map(|c| c.gradient.as_ref())
    }

    /// The equations with the sticking forces left open.
    pub(crate) fn affine(&self, state: &[f64; N], modes: &Modes<M, N>) -> Affine<M, f64, N> {
        Affine::new(self.constants.as_ref(), &self.plain, state, modes)
    }

    /// All that is known at a state.
    ///
    /// # Errors
    /// The sticking forces are not unique, or push the wrong way.
    pub(crate) fn snapshot(
        &self,
        state: &[f64; N],
        modes: &Modes<M, N>,
    ) -> Result<Snapshot<M, f64, N>, ContactError> {
        let affine = self.affine(state, modes);
        for contact in modes.sticking() {
            let compliance = affine.compliance.as_ref()[contact].as_ref()[contact];
            if compliance <= 0.0 {
                return Err(ContactError::NotOpposing {
                    contact,
                    compliance,
                });
            }
        }
        affine.resolve(modes).ok_or_else(|| singular(modes))
    }

    /// The same, each number with its rate along the motion.
    ///
    /// # Errors
    /// As [`ExactSystem::snapshot`].
    pub(crate) fn moving(
        &self,
        state: &[f64; N],
        modes: &Modes<M, N>,
    ) -> Result<Snapshot<M, Dual64, N>, ContactError> {
        let field = self.snapshot(state, modes)?.field;
        let state = std::array::from_fn(|i| Dual64::new(state[i], field[i]));
        Affine::new(self.constants.as_ref(), &self.directional, &state, modes)
            .resolve(modes)
            .ok_or_else(|| singular(modes))
    }

    /// The same, each number with its derivatives by the states and the design variable.
    ///
    /// # Errors
    /// As [`ExactSystem::snapshot`].
    pub(crate) fn linear(
        &self,
        state: &[f64; N],
        modes: &Modes<M, N>,
    ) -> Result<Snapshot<M, M::Lanes, N>, ContactError> {
        let state = std::array::from_fn(|i| M::Lanes::state(state[i], i));
        Affine::new(self.constants.as_ref(), &self.lanes, &state, modes)
            .resolve(modes)
            .ok_or_else(|| singular(modes))
    }

    /// ẅ of every contact, from f and its rate along the motion.
    pub(crate) fn second_rates(
        &self,
        state: &[f64; N],
        modes: &Modes<M, N>,
        field: &[Dual64; N],
    ) -> M::PerContact<f64> {
        let state = std::array::from_fn(|i| Dual64::new(state[i], field[i].re));
        let rates = speed_rates::<M, Dual64, N>(&self.directional, &state, modes, field);
        Inline::from_fn(|i| rates.as_ref()[i].eps)
    }

    /// The relative speed of every contact, without its friction.
    pub(crate) fn speeds(&self, state: &[f64; N]) -> M::PerContact<f64> {
        let modes = Modes::<M, N>::from_fn(|_| Mode::Stick);
        let mut rule = Branches::<M, f64, N>::free(modes.as_slice());
        let _ = M::rhs(&self.plain, *state, &mut rule);
        rule.speed
    }

    /// The relative speed of every contact, with its derivatives.
    pub(crate) fn linear_speeds(&self, state: &[f64; N]) -> M::PerContact<M::Lanes> {
        let modes = Modes::<M, N>::from_fn(|_| Mode::Stick);
        let lanes = std::array::from_fn(|i| M::Lanes::state(state[i], i));
        let mut rule = Branches::<M, M::Lanes, N>::free(modes.as_slice());
        let _ = M::rhs(&self.lanes, lanes, &mut rule);
        rule.speed
    }

    /// slip(0⁺) of every contact.
    pub(crate) fn slip_at_rest(&self, state: &[f64; N]) -> M::PerContact<f64> {
        let mut rule = AtRest::<M, N>(Inline::from_fn(|_| 0.0));
        let _ = M::rhs(&self.plain, *state, &mut rule);
        rule.0
    }
}

/// Notes the limit of every sliding force at speed 0.
struct AtRest<M: Model<N>, const N: usize>(M::PerContact<f64>);

impl<M: Model<N>, const N: usize> crate::friction::ContactRule<f64> for AtRest<M, N> {
    fn force<L: crate::friction::FrictionLaw<f64>>(
        &mut self,
        contact: usize,
        law: &L,
        _: f64,
    ) -> f64 {
        if let Some(place) = self.0.as_mut().get_mut(contact) {
            *place = law.slip(0.0);
        }
        0.0
    }
}

fn singular<M: Model<N>, const N: usize>(modes: &Modes<M, N>) -> ContactError {
    ContactError::Singular {
        contacts: modes.sticking().collect(),
    }
}

/// The exact field while every contact keeps its mode.
pub struct ExactField<'s, M: Model<N>, const N: usize> {
    system: &'s ExactSystem<M, N>,
    modes: Modes<M, N>,
    /// Numbers of the contacts that stick, then of the others.
    order: M::PerContact<usize>,
    sticking: usize,
    /// B_S G_SS⁻¹ column by column, if it does not depend on the state: then f = f₀ − Σ lever (w_y f₀).
    levers: Option<M::PerContact<[f64; N]>>,
}

impl<'s, M: Model<N>, const N: usize> ExactField<'s, M, N> {
    /// The field of `system` in these modes.
    ///
    /// # Errors
    /// The sticking forces are not unique at `state`, or push the wrong way.
    pub fn new(
        system: &'s ExactSystem<M, N>,
        modes: Modes<M, N>,
        state: &[f64; N],
    ) -> Result<Self, ContactError> {
        system.snapshot(state, &modes)?;
        let mut order: M::PerContact<usize> = Inline::from_fn(|i| i);
        let sticks = |i: &usize| modes.as_slice()[*i] == Mode::Stick;
        order.as_mut().sort_by_key(|i| !sticks(i));
        let levers = match &system.constants {
            Some(constants) => Some(constants.levers(&modes).ok_or_else(|| singular(&modes))?),
            None => None,
        };
        Ok(Self {
            system,
            sticking: modes.sticking().count(),
            modes,
            order,
            levers,
        })
    }

    /// The modes.
    #[must_use]
    pub fn modes(&self) -> &Modes<M, N> {
        &self.modes
    }

    /// Whether any contact sticks.
    #[must_use]
    pub fn sticks(&self) -> bool {
        self.sticking > 0
    }

    /// The smallest change of the state by sticking forces that changes the speeds of the sticking
    /// contacts by `speeds`: B_S G_SS⁻¹ w_S; zero where the forces are not unique.
    pub(crate) fn correction(&self, state: &[f64; N], speeds: &M::PerContact<f64>) -> [f64; N] {
        let mut change = [0.0; N];
        let mut add = |input: &[f64; N], push: f64| {
            for (c, b) in change.iter_mut().zip(input) {
                *c += b * push;
            }
        };
        if let Some(levers) = &self.levers {
            for contact in self.stuck() {
                add(&levers.as_ref()[contact], speeds.as_ref()[contact]);
            }
        } else if self.sticks() {
            let affine = self.system.affine(state, &self.modes);
            if let Some(push) = affine.respond(&self.modes, speeds) {
                for contact in self.stuck() {
                    add(&affine.input.as_ref()[contact], push.as_ref()[contact]);
                }
            }
        }
        change
    }

    fn stuck(&self) -> impl Iterator<Item = usize> {
        self.order.as_ref().iter().copied().take(self.sticking)
    }

    /// f over any scalar; NaN where the sticking forces are not unique.
    #[inline]
    fn evaluate<D: Scalar>(&self, params: &M::Params<D>, state: &[D; N]) -> [D; N] {
        if self.sticks() && self.levers.is_none() {
            return Affine::new(None, params, state, &self.modes)
                .resolve(&self.modes)
                .map_or([D::from(f64::NAN); N], |snapshot| snapshot.field);
        }
        let mut rule = Branches::<M, D, N>::free(self.modes.as_slice());
        let mut field = M::rhs(params, *state, &mut rule);
        if let (Some(levers), Some(gradients)) = (&self.levers, self.system.gradients()) {
            for contact in self.stuck() {
                hold(&mut field, &gradients[contact], &levers.as_ref()[contact]);
            }
        }
        field
    }
}

/// f ← f − lever (w_y f): the sticking force of one contact, given that the lever of no other moves w.
#[inline]
fn hold<D: Scalar, const N: usize>(field: &mut [D; N], gradient: &[f64; N], lever: &[f64; N]) {
    let mut rate = D::from(0.0);
    for (f, g) in field.iter().zip(gradient) {
        if *g != 0.0 {
            rate += *f * *g;
        }
    }
    for (f, b) in field.iter_mut().zip(lever) {
        if *b != 0.0 {
            *f -= rate * *b;
        }
    }
}

impl<M: Model<N>, const N: usize> Field<N> for ExactField<'_, M, N> {
    const KINEMATIC: [Option<usize>; N] = M::KINEMATIC;

    #[inline]
    fn f(&self, y: &[f64; N]) -> [f64; N] {
        self.evaluate(&self.system.plain, y)
    }

    #[inline]
    fn linearise(&self, y: &[f64; N]) -> Linear<N> {
        let state = std::array::from_fn(|i| M::Lanes::state(y[i], i));
        linear_of(&self.evaluate(&self.system.lanes, &state))
    }
}

/// Values, Jacobian and design column out of the lanes.
#[inline]
pub(crate) fn linear_of<L: Lanes<N>, const N: usize>(field: &[L; N]) -> Linear<N> {
    let slopes: [_; N] = std::array::from_fn(|i| field[i].slopes());
    Linear {
        f: std::array::from_fn(|i| field[i].re()),
        jacobian: slopes.map(|(state, _)| state),
        design: slopes.map(|(_, design)| design),
    }
}

#[cfg(test)]
mod tests;

//! A model at given parameters, asked for everything that its contacts do at one state.

use num_dual::Dual64;

use super::affine::{Affine, Snapshot, Square, speed_rates};
use super::columns::Columns;
use super::constants::Constants;
use super::error::{ContactError, opposing, singular};
use super::load::bent;
use super::mode::Modes;
use super::pressed::rough;
use super::rest::{idle, layers, limits};
use super::rule::Branches;
use super::tied::ties;
use crate::field::{Strip, memory};
use crate::model::Model;
use crate::scalar::{Inline, Lanes, Scalar};

/// What one contact does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactState {
    /// Relative speed w.
    pub speed: f64,
    /// Friction force λ as it stands in the equations.
    pub force: f64,
    /// Largest force at rest.
    pub stick: f64,
}

/// A model at given parameters, its parameters lifted once to every scalar in use.
pub struct ExactSystem<M: Model<N>, const N: usize> {
    pub(super) plain: M::Params<f64>,
    pub(super) directional: M::Params<Dual64>,
    /// The parameters moving with the design variable.
    pub(super) turned: M::Params<Dual64>,
    pub(super) columns: Columns<N>,
    pub(super) lanes: M::Params<M::Lanes>,
    pub(super) constants: Option<Constants<M, N>>,
    /// Usual magnitudes of the states: what errors are measured against where they pass through zero.
    pub(crate) magnitude: [f64; N],
    /// Number of kinks of laws with internal state.
    pub(super) corners: usize,
    /// Which contacts no force ever holds: where w = 0 nothing happens to them.
    pub(super) idle: M::PerContact<bool>,
    /// Which presses have a force that is no power series in the depth.
    pub(super) rough: M::PerContact<bool>,
    /// Which contacts move as a gap that does not give way does.
    pub(super) ties: Square<M, bool, N>,
}

impl<M: Model<N>, const N: usize> ExactSystem<M, N> {
    /// The model with the parameter of index `design`, if any, as design variable.
    #[must_use]
    pub fn new(model: &M, design: Option<usize>) -> Self {
        let plain = model.values();
        let values = plain.as_ref();
        let lanes = Inline::from_fn(|i| M::Lanes::design(values[i], f64::from(design == Some(i))));
        let turned = Inline::from_fn(|i| Dual64::new(values[i], f64::from(design == Some(i))));
        Self {
            plain,
            directional: Inline::from_fn(|i| Dual64::from(values[i])),
            columns: Columns::of::<M>(design.is_some()),
            constants: Constants::find(&turned),
            lanes,
            magnitude: memory::bounded::<M, N>(&plain, [1.0; N]),
            corners: memory::corners::<M, N>(&plain),
            idle: idle::<M, N>(&turned),
            rough: rough::<M, N>(&turned),
            ties: ties::<M, N>(&lanes, &plain),
            turned,
        }
    }

    /// The same system, its states measured against these magnitudes where they pass through zero.
    pub(crate) fn with_magnitude(mut self, magnitude: [f64; N]) -> Self {
        self.magnitude = memory::bounded::<M, N>(&self.plain, magnitude);
        self
    }

    /// Number of contacts, those that press included.
    #[must_use]
    pub fn contacts(&self) -> usize {
        M::INFO.contacts.len() + M::INFO.presses.len()
    }

    /// Checks what does not depend on the state.
    ///
    /// # Errors
    /// A force that never opposes its speed.
    pub fn check(&self) -> Result<(), ContactError> {
        let all = Modes::held();
        if let Some(constants) = &self.constants {
            opposing::<M, N>(&constants.compliance, &all)?;
        }
        match bent::<M, N>(&self.directional) {
            Some((contact, press)) => {
                let [contact, press] = [contact, press].map(|i| M::INFO.contact_id(i));
                Err(ContactError::Bent { contact, press })
            }
            None => Ok(()),
        }
    }

    /// w_y of each contact, if none depends on the state.
    pub(crate) fn gradients(&self) -> Option<&[Strip<N>]> {
        self.constants.as_ref().map(|c| c.gradient.as_ref())
    }

    /// What is constant, where that is all that is asked for: not while presses are at rest.
    pub(super) fn constants_in(&self, modes: &Modes<M, N>) -> Option<&Constants<M, N>> {
        self.constants.as_ref().filter(|_| !modes.rests())
    }

    /// Whether the speed or gap of a contact is known to be affine.
    pub(crate) fn is_straight(&self, contact: usize) -> bool {
        let constants = self.constants.as_ref();
        constants.is_some_and(|constants| constants.is_straight(contact))
    }

    /// Usual magnitude of a contact's relative speed, as far as that of the states tells.
    pub(crate) fn usual_speed(&self, contact: usize) -> f64 {
        let Some(gradients) = self.gradients() else {
            return 1.0;
        };
        let terms = gradients[contact].iter();
        terms
            .map(|(j, slope)| (slope * self.magnitude[j]).abs())
            .sum()
    }

    /// Speed within which each sliding force changes by as much as itself: slip(0⁺)/|slip'(0⁺)|.
    pub(super) fn layers(&self, state: &[f64; N]) -> M::PerContact<f64> {
        layers::<M, N>(&self.directional, state)
    }

    /// stick and slip(0⁺) of every contact, each that a reaction presses as if that were a unit force.
    pub(crate) fn limits_at_rest(&self, state: &[f64; N]) -> M::PerContact<(f64, f64)> {
        let reaction = |press| M::INFO.is_rigid(press).then_some(1.0);
        limits::<M, f64, N>(&self.plain, state, &reaction)
    }

    /// The same under these reactions.
    pub(crate) fn limits_under(
        &self,
        state: &[f64; N],
        reactions: &M::PerContact<f64>,
    ) -> M::PerContact<(f64, f64)> {
        let reaction = |press| M::INFO.is_rigid(press).then(|| reactions.as_ref()[press]);
        limits::<M, f64, N>(&self.plain, state, &reaction)
    }

    /// Whether no force ever holds this contact: where w = 0 nothing happens to it.
    pub(crate) fn is_idle(&self, contact: usize) -> bool {
        self.idle.as_ref()[contact]
    }

    /// Whether there is a design variable.
    pub(crate) fn is_designed(&self) -> bool {
        self.turned
            .as_ref()
            .iter()
            .any(|parameter| parameter.eps != 0.0)
    }

    /// The values of the parameters.
    pub(crate) fn values(&self) -> &M::Params<f64> {
        &self.plain
    }

    /// The equations with the sticking forces left open.
    pub(crate) fn affine(&self, state: &[f64; N], modes: &Modes<M, N>) -> Affine<M, f64, N> {
        Affine::new(self.constants_in(modes), &self.plain, state, modes)
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
        if let Some(constants) = self.constants_in(modes) {
            opposing::<M, N>(&constants.compliance, modes)?;
            return constants
                .snapshot(&self.plain, state, modes)
                .ok_or_else(|| singular(modes));
        }
        let affine = self.affine(state, modes);
        opposing::<M, N>(&affine.compliance, modes)?;
        affine
            .resolve(&self.plain, state, modes)
            .ok_or_else(|| singular(modes))
    }

    /// The same over any scalar, where nothing is known to push the wrong way.
    fn known<D: Scalar>(
        &self,
        params: &M::Params<D>,
        state: &[D; N],
        modes: &Modes<M, N>,
    ) -> Result<Snapshot<M, D, N>, ContactError> {
        let known = match self.constants_in(modes) {
            Some(constants) => constants.snapshot(params, state, modes),
            None => Affine::new(None, params, state, modes).resolve(params, state, modes),
        };
        known.ok_or_else(|| singular(modes))
    }

    /// What every contact does at a state.
    ///
    /// # Errors
    /// The sticking forces are not unique, or push the wrong way.
    pub fn contact_states(
        &self,
        state: &[f64; N],
        modes: &Modes<M, N>,
    ) -> Result<M::PerContact<ContactState>, ContactError> {
        let at = self.snapshot(state, modes)?;
        Ok(Inline::from_fn(|i| ContactState {
            speed: at.speed.as_ref()[i],
            force: at.force.as_ref()[i],
            stick: at.stick.as_ref()[i],
        }))
    }

    /// All that is known at a state, each number with its rate along the motion.
    ///
    /// # Errors
    /// As [`ExactSystem::snapshot`].
    pub(crate) fn moving(
        &self,
        state: &[f64; N],
        modes: &Modes<M, N>,
    ) -> Result<Snapshot<M, Dual64, N>, ContactError> {
        let field = self.snapshot(state, modes)?.field;
        let state = crate::scalar::filled(|i| Dual64::new(state[i], field[i]));
        self.known(&self.directional, &state, modes)
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
        let state = crate::scalar::filled(|i| M::Lanes::state(state[i], i));
        self.known(&self.lanes, &state, modes)
    }

    /// ẅ of every contact, from f and its rate along the motion.
    pub(crate) fn second_rates(
        &self,
        state: &[f64; N],
        modes: &Modes<M, N>,
        field: &[Dual64; N],
    ) -> M::PerContact<f64> {
        let state = crate::scalar::filled(|i| Dual64::new(state[i], field[i].re));
        let rates = speed_rates::<M, Dual64, N>(&self.directional, &state, modes, field);
        Inline::from_fn(|i| rates.as_ref()[i].eps)
    }

    /// The relative speed of every contact, without its friction.
    pub(crate) fn speeds(&self, state: &[f64; N]) -> M::PerContact<f64> {
        let modes = Modes::<M, N>::held();
        let mut rule = Branches::<M, f64, N>::free(modes.as_slice());
        let _ = M::rhs(&self.plain, *state, &mut rule);
        rule.speed
    }

    /// The relative speed of every contact, without its friction, and of presses at rest the rates of their gaps.
    pub(crate) fn rates(&self, state: &[f64; N], modes: &Modes<M, N>) -> M::PerContact<f64> {
        let mut rule = Branches::<M, f64, N>::free(modes.as_slice());
        let _ = M::rhs(&self.plain, *state, &mut rule);
        rule.speed
    }

    /// The relative speed of every contact, with its derivatives.
    pub(crate) fn linear_speeds(&self, state: &[f64; N]) -> M::PerContact<M::Lanes> {
        self.linear_rates(state, &Modes::held())
    }

    /// The same, and of presses at rest the rates of their gaps.
    pub(crate) fn linear_rates(
        &self,
        state: &[f64; N],
        modes: &Modes<M, N>,
    ) -> M::PerContact<M::Lanes> {
        let lanes = crate::scalar::filled(|i| M::Lanes::state(state[i], i));
        let mut rule = Branches::<M, M::Lanes, N>::free(modes.as_slice());
        let _ = M::rhs(&self.lanes, lanes, &mut rule);
        rule.speed
    }
}

//! The equations as an affine function of the forces of the sticking contacts: f₀ + Σ Bᵢ λᵢ and b + G λ (0.2).

use num_dual::Dual;

use super::constants::Constants;
use super::mode::{Mode, Modes};
use super::rule::Branches;
use super::solve::solve;
use crate::model::Model;
use crate::scalar::{Inline, Scalar, filled, mapped};

/// What a correction leaves of a number, as a share of that, where it takes out all but rounding errors.
pub(super) const NOTHING: f64 = 1e-8;

/// A matrix with one row and one column for each contact.
pub(crate) type Square<M, D, const N: usize> =
    <M as Model<N>>::PerContact<<M as Model<N>>::PerContact<D>>;

/// The equations at one state while some contacts stick, their forces left open.
///
/// Entries of contacts that slide are 0 in `input`, `rate` and `compliance`.
pub(crate) struct Affine<M: Model<N>, D: Scalar, const N: usize> {
    /// f₀: the field without the sticking forces.
    pub(crate) field: [D; N],
    /// Bᵢ.
    pub(crate) input: M::PerContact<[D; N]>,
    /// bᵢ: the rate of wᵢ without the sticking forces.
    pub(crate) rate: M::PerContact<D>,
    /// G.
    pub(crate) compliance: Square<M, D, N>,
    /// wᵢ.
    pub(crate) speed: M::PerContact<D>,
    /// λᵢ of the contacts that slide.
    pub(crate) force: M::PerContact<D>,
    /// Largest force at rest.
    pub(crate) stick: M::PerContact<D>,
}

/// All that is known at one state in one mode.
pub(crate) struct Snapshot<M: Model<N>, D: Scalar, const N: usize> {
    /// f.
    pub(crate) field: [D; N],
    /// wᵢ.
    pub(crate) speed: M::PerContact<D>,
    /// λᵢ.
    pub(crate) force: M::PerContact<D>,
    /// Largest force at rest.
    pub(crate) stick: M::PerContact<D>,
}

impl<M: Model<N>, D: Scalar, const N: usize> Affine<M, D, N> {
    /// At a state: from what is constant in the model, where anything is, otherwise by probing.
    pub(super) fn new(
        constants: Option<&Constants<M, N>>,
        params: &M::Params<D>,
        state: &[D; N],
        modes: &Modes<M, N>,
    ) -> Self {
        let zero = D::from(0.0);
        let mut rule = Branches::<M, D, N>::free(modes.as_slice());
        let mut affine = Self {
            field: M::rhs(params, *state, &mut rule),
            input: Inline::from_fn(|_| [zero; N]),
            rate: Inline::from_fn(|_| zero),
            compliance: Inline::from_fn(|_| Inline::from_fn(|_| zero)),
            speed: rule.speed,
            force: rule.force,
            stick: rule.stick,
        };
        match constants {
            Some(constants) => affine.lift(constants, modes),
            None => affine.probe(params, state, modes),
        }
        affine
    }

    fn lift(&mut self, constants: &Constants<M, N>, modes: &Modes<M, N>) {
        for row in modes.bound() {
            self.rate.as_mut()[row] = constants.gradient.as_ref()[row].dot(&self.field);
            self.input.as_mut()[row] = mapped(constants.input.as_ref()[row].entries(), D::from);
            for column in modes.bound() {
                let entry = constants.compliance.as_ref()[row].as_ref()[column];
                self.compliance.as_mut()[row].as_mut()[column] = D::from(entry);
            }
        }
    }

    /// Probes the right-hand side with dual numbers: B by seeding the forces, b and G by moving along f₀ and B.
    fn probe(&mut self, params: &M::Params<D>, state: &[D; N], modes: &Modes<M, N>) {
        if modes.bound().next().is_none() {
            return;
        }
        let drift = speed_rates::<M, D, N>(params, state, modes, &self.field);
        for row in modes.bound() {
            self.rate.as_mut()[row] = drift.as_ref()[row];
        }
        for column in modes.bound() {
            let push = input(params, state, modes, column);
            let response = speed_rates::<M, D, N>(params, state, modes, &push);
            self.input.as_mut()[column] = push;
            for row in modes.bound() {
                self.compliance.as_mut()[row].as_mut()[column] = response.as_ref()[row];
            }
        }
    }

    /// The forces that keep ẇ = 0 where contacts stick, and gaps closed where presses are at rest; `None` if they are not
    /// unique.
    pub(super) fn sticking_forces(&self, modes: &Modes<M, N>) -> Option<M::PerContact<D>> {
        let mut forces = self.force;
        for contact in modes.bound() {
            forces.as_mut()[contact] = -self.rate.as_ref()[contact];
        }
        self.respond(modes, forces)
    }

    /// The forces of the contacts that bind and change their speeds at these rates: G_SS⁻¹ w_S; elsewhere as given.
    pub(super) fn respond(
        &self,
        modes: &Modes<M, N>,
        mut rates: M::PerContact<D>,
    ) -> Option<M::PerContact<D>> {
        let (mut rows, bound) = (self.compliance, modes.which(Mode::binds));
        solve(rows.as_mut(), rates.as_mut(), bound.as_ref())?;
        Some(rates)
    }

    /// The field with the sticking forces in place; `None` if they are not unique.
    pub(super) fn resolve(
        &self,
        params: &M::Params<D>,
        state: &[D; N],
        modes: &Modes<M, N>,
    ) -> Option<Snapshot<M, D, N>> {
        let force = self.sticking_forces(modes)?;
        if const { Modes::<M, N>::PRESSED } {
            if modes.rests() {
                return self.pressed(force, params, state, modes);
            }
        }
        let mut field = self.field;
        for contact in modes.bound() {
            let (push, input) = (force.as_ref()[contact], &self.input.as_ref()[contact]);
            for (f, b) in field.iter_mut().zip(input) {
                *f += *b * push;
            }
        }
        Some(Snapshot {
            field,
            speed: self.speed,
            force,
            stick: self.stick,
        })
    }
}

impl<M: Model<N>, D: Scalar, const N: usize> Affine<M, D, N> {
    /// The same where presses are at rest. Friction reads reactions: what it was without them says nothing.
    fn pressed(
        &self,
        force: M::PerContact<D>,
        params: &M::Params<D>,
        state: &[D; N],
        modes: &Modes<M, N>,
    ) -> Option<Snapshot<M, D, N>> {
        let mut rule = Branches::<M, D, N>::with(modes.as_slice(), force);
        let field = M::rhs(params, *state, &mut rule);
        Some(Snapshot {
            field: self.refined(field, params, state, modes)?,
            speed: rule.speed,
            force: rule.force,
            stick: rule.stick,
        })
    }

    /// The field once more without what it does to gaps that stay closed and to contacts that stick: of what is at rest,
    /// exactly nothing is left, and a rounding error would be all that moves.
    fn refined(
        &self,
        field: [D; N],
        params: &M::Params<D>,
        state: &[D; N],
        modes: &Modes<M, N>,
    ) -> Option<[D; N]> {
        let rates = speed_rates::<M, D, N>(params, state, modes, &field);
        let push = self.respond(modes, rates)?;
        let mut refined = field;
        for contact in modes.bound() {
            let (push, input) = (push.as_ref()[contact], &self.input.as_ref()[contact]);
            for (f, b) in refined.iter_mut().zip(input) {
                *f -= *b * push;
            }
        }
        for (f, before) in refined.iter_mut().zip(&field) {
            if f.re().abs() <= NOTHING * before.re().abs() {
                let nothing = D::from(f.re());
                *f -= nothing;
            }
        }
        Some(refined)
    }
}

/// Bᵢ: what a unit force of one contact adds to the field, free of cancellation.
pub(super) fn input<M: Model<N>, D: Scalar, const N: usize>(
    params: &M::Params<D>,
    state: &[D; N],
    modes: &Modes<M, N>,
    contact: usize,
) -> [D; N] {
    let still = |x: D| Dual::new(x, D::from(0.0));
    let unit = |i| Dual::new(D::from(0.0), D::from(f64::from(i == contact)));
    let mut rule = Branches::<M, Dual<D>, N>::with(modes.as_slice(), Inline::from_fn(unit));
    let lifted = Inline::from_fn(|i| still(params.as_ref()[i]));
    let field = M::rhs(&lifted, mapped(state, still), &mut rule);
    mapped(&field, |f| f.eps)
}

/// w_y u for every contact: how fast its speed changes when the state moves along `direction`.
pub(super) fn speed_rates<M: Model<N>, D: Scalar, const N: usize>(
    params: &M::Params<D>,
    state: &[D; N],
    modes: &Modes<M, N>,
    direction: &[D; N],
) -> M::PerContact<D> {
    let mut rule = Branches::<M, Dual<D>, N>::free(modes.as_slice());
    let lifted = Inline::from_fn(|i| Dual::new(params.as_ref()[i], D::from(0.0)));
    let moving = filled(|i| Dual::new(state[i], direction[i]));
    // Only the speeds matter, which no force enters.
    let _ = M::rhs(&lifted, moving, &mut rule);
    Inline::from_fn(|i| rule.speed.as_ref()[i].eps)
}

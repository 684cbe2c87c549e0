//! Impacts: a contact that does not give way turns the speed of its approach by an impulse along its reaction, and by those
//! of the friction that this causes.

use num_dual::Dual64;

use super::affine::{Affine, input, speed_rates};
use super::error::{ContactError, opposing, singular};
use super::load::grips;
use super::mode::{Mode, Modes};
use super::rule::Branches;
use super::system::ExactSystem;
use crate::friction::{ContactRule, FrictionLaw};
use crate::model::Model;
use crate::press::PressLaw;
use crate::scalar::{Inline, Lanes, Scalar, mapped};

/// Which impulses an impact has: the press that is hit is in the mode of rest, friction that this causes sticks or slides,
/// and nothing else acts.
pub(crate) struct Impulses<M: Model<N>, const N: usize> {
    /// The press that is hit.
    pub(crate) press: usize,
    /// Who takes part.
    pub(crate) modes: Modes<M, N>,
    /// Whether the press stays closed, instead of parting as its law says.
    pub(crate) lasts: bool,
}

/// An impact over any scalar.
pub(crate) struct Impact<M: Model<N>, D: Scalar, const N: usize> {
    /// The state after it.
    pub(crate) state: [D; N],
    /// Speed at which the gap closed.
    pub(crate) approach: D,
    /// Speed at which it opens.
    pub(crate) departure: D,
    /// Impulse of each contact.
    pub(crate) impulse: M::PerContact<D>,
    /// Relative speed of each contact before, of the press the rate of its gap.
    pub(crate) before: M::PerContact<D>,
    /// The same after.
    pub(crate) after: M::PerContact<D>,
}

impl<M: Model<N>, const N: usize> ExactSystem<M, N> {
    /// An impact at a state.
    ///
    /// # Errors
    /// The impulses are not unique, or push the wrong way.
    pub(crate) fn impact(
        &self,
        state: &[f64; N],
        impulses: &Impulses<M, N>,
    ) -> Result<Impact<M, f64, N>, ContactError> {
        let affine = Affine::new(None, &self.plain, state, &impulses.modes);
        opposing::<M, N>(&affine.compliance, &impulses.modes)?;
        impact(&self.plain, state, impulses, &affine).ok_or_else(|| singular(&impulses.modes))
    }

    /// The same with derivatives by the states and the design variable.
    ///
    /// # Errors
    /// As [`ExactSystem::impact`].
    pub(crate) fn linear_impact(
        &self,
        state: &[f64; N],
        impulses: &Impulses<M, N>,
    ) -> Result<Impact<M, M::Lanes, N>, ContactError> {
        let lanes = crate::scalar::filled(|i| M::Lanes::state(state[i], i));
        let affine = Affine::new(None, &self.lanes, &lanes, &impulses.modes);
        impact(&self.lanes, &lanes, impulses, &affine).ok_or_else(|| singular(&impulses.modes))
    }

    /// How fast the gap of a press closes, and how fast it would open after an impact.
    pub(crate) fn approach(&self, state: &[f64; N], press: usize) -> (f64, f64) {
        let (rate, rebound) = rebound::<M, f64, N>(&self.plain, state, press);
        (-rate, rebound)
    }

    /// What an impact adds to the state for each unit of its speed of approach, as that vanishes: B (1 + e)/G with the slope
    /// e of the rebound.
    ///
    /// # Errors
    /// The impulses are not unique, or push the wrong way.
    pub(crate) fn kick(
        &self,
        state: &[f64; N],
        press: usize,
        modes: &Modes<M, N>,
    ) -> Result<[f64; N], ContactError> {
        let affine = Affine::new(None, &self.plain, state, modes);
        opposing::<M, N>(&affine.compliance, modes)?;
        let push = affine.input.as_ref()[press];
        let moving = crate::scalar::filled(|i| Dual64::new(state[i], push[i]));
        let (rate, rebound) = rebound::<M, Dual64, N>(&self.directional, &moving, press);
        let restitution = -rebound.eps / rate.eps;
        let unit = Inline::from_fn(|i| if i == press { 1.0 + restitution } else { 0.0 });
        let impulse = affine.respond(modes, unit).ok_or_else(|| singular(modes))?;
        let impulse = impulse.as_ref()[press];
        Ok(mapped(&push, |b| b * impulse))
    }

    /// How fast the speeds of what sticks change along a direction.
    pub(crate) fn rates_along(
        &self,
        state: &[f64; N],
        modes: &Modes<M, N>,
        direction: &[f64; N],
    ) -> M::PerContact<f64> {
        speed_rates::<M, f64, N>(&self.plain, state, modes, direction)
    }

    /// How the friction of each contact grows with the reaction of a press: at speed 0, and at the speed that it has.
    pub(crate) fn grips(&self, state: &[f64; N], press: usize) -> M::PerContact<[f64; 2]> {
        grips::<M, N>(&self.directional, state, press)
    }

    /// Whether an impulse of one press, or of the friction that it causes, acts on the gap of another, or on what rubs
    /// under that.
    pub(crate) fn acts_on(&self, state: &[f64; N], press: usize, other: usize) -> bool {
        let part = |of: usize| {
            Modes::<M, N>::from_fn(|i| match i {
                i if i == press || i == other => Mode::Rest,
                i if M::INFO.rubs_under(of).any(|j| j == i) => Mode::Stick,
                i if i < M::INFO.contacts.len() => Mode::Loose,
                _ => Mode::Open,
            })
        };
        let (pushing, pushed) = (part(press), part(other));
        let sources = M::INFO.rubs_under(press).chain([press]);
        let mut responses = sources.map(|source| {
            let push = input::<M, f64, N>(&self.plain, state, &pushing, source);
            speed_rates::<M, f64, N>(&self.plain, state, &pushed, &push)
        });
        responses.any(|rates| {
            let mut targets = M::INFO.rubs_under(other).chain([other]);
            targets.any(|target| rates.as_ref()[target] != 0.0)
        })
    }
}

/// y⁺ = y + Σ B Λ, with the impulses Λ that turn the approach into the departure and hold what sticks.
fn impact<M: Model<N>, D: Scalar, const N: usize>(
    params: &M::Params<D>,
    state: &[D; N],
    impulses: &Impulses<M, N>,
    affine: &Affine<M, D, N>,
) -> Option<Impact<M, D, N>> {
    let (press, modes) = (impulses.press, &impulses.modes);
    let (rate, rebound) = rebound::<M, D, N>(params, state, press);
    let departure = if impulses.lasts {
        D::from(0.0)
    } else {
        rebound
    };
    let change = Inline::from_fn(|i| match i == press {
        true => departure - rate,
        false => -affine.speed.as_ref()[i],
    });
    let impulse = affine.respond(modes, change)?;
    let mut after = *state;
    for contact in modes.bound() {
        let (push, input) = (impulse.as_ref()[contact], &affine.input.as_ref()[contact]);
        for (y, b) in after.iter_mut().zip(input) {
            *y += *b * push;
        }
    }
    let mut rule = Branches::<M, D, N>::free(modes.as_slice());
    let _ = M::rhs(params, after, &mut rule);
    Some(Impact {
        state: after,
        approach: -rate,
        departure,
        impulse,
        before: affine.speed,
        after: rule.speed,
    })
}

/// How fast a gap opens, and how fast it would after an impact.
fn rebound<M: Model<N>, D: Scalar, const N: usize>(
    params: &M::Params<D>,
    state: &[D; N],
    press: usize,
) -> (D, D) {
    let mut rule = Rebound {
        press,
        rate: D::from(0.0),
        rebound: D::from(0.0),
    };
    let _ = M::rhs(params, *state, &mut rule);
    (rule.rate, rule.rebound)
}

/// Notes what the gap of one press does. No force matters: none acts on the rate of a gap.
struct Rebound<D> {
    press: usize,
    rate: D,
    rebound: D,
}

impl<D: Scalar> ContactRule<D> for Rebound<D> {
    fn force<L: FrictionLaw<D>>(&mut self, _: usize, _: &L, _: D) -> D {
        D::from(0.0)
    }

    fn press<L: PressLaw<D>>(&mut self, contact: usize, law: &L, _: D, rate: D) -> D {
        if contact == self.press {
            self.rate = rate;
            self.rebound = law.rebound(-rate);
        }
        D::from(0.0)
    }
}

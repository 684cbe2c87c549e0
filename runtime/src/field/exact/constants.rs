//! What does not depend on the state: gradients of affine speeds, and how forces enter.

use super::affine::{Square, input, speed_rates};
use super::mode::{Mode, Modes};
use super::rule::Branches;
use super::solve::solve;
use crate::model::Model;
use crate::scalar::{Inline, Lanes};

/// w_y, w_r, B and G of a model in which they are the same at every state and every value of the design variable.
#[derive(Clone, Copy)]
pub(crate) struct Constants<M: Model<N>, const N: usize> {
    /// w_y of each contact.
    pub(crate) gradient: M::PerContact<[f64; N]>,
    /// Bᵢ of each contact.
    pub(crate) input: M::PerContact<[f64; N]>,
    /// G.
    pub(crate) compliance: Square<M, f64, N>,
}

impl<M: Model<N>, const N: usize> Constants<M, N> {
    /// Finds them, or `None` if second derivatives at generic states show that they are not constant.
    pub(super) fn find(params: &M::Params<M::Lanes>) -> Option<Self> {
        let first = Self::at(params, &generic_state::<M, N>(0.317))?;
        let second = Self::at(params, &generic_state::<M, N>(0.871))?;
        let same =
            |a: &M::PerContact<[f64; N]>, b: &M::PerContact<[f64; N]>| a.as_ref() == b.as_ref();
        (same(&first.gradient, &second.gradient) && same(&first.input, &second.input))
            .then_some(first)
    }

    fn at(params: &M::Params<M::Lanes>, state: &[f64; N]) -> Option<Self> {
        let modes = Modes::from_fn(|_| Mode::Stick);
        let lanes: [M::Lanes; N] = std::array::from_fn(|i| M::Lanes::state(state[i], i));
        let direction = std::array::from_fn(|i| M::Lanes::constant(generic(i, 0.713)));
        let bend = speed_rates::<M, M::Lanes, N>(params, &lanes, &modes, &direction);
        let straight = bend.as_ref().iter().all(|rate| flat(rate).is_some());
        let mut rule = Branches::<M, M::Lanes, N>::free(modes.as_slice());
        let _ = M::rhs(params, lanes, &mut rule);
        let gradient: M::PerContact<[f64; N]> =
            Inline::from_fn(|i| rule.speed.as_ref()[i].slopes().0);
        let mut forces: M::PerContact<[f64; N]> = Inline::from_fn(|_| [0.0; N]);
        for (contact, slot) in forces.as_mut().iter_mut().enumerate() {
            let column = input::<M, M::Lanes, N>(params, &lanes, &modes, contact);
            for (entry, b) in slot.iter_mut().zip(&column) {
                *entry = flat(b)?;
            }
        }
        let compliance = Inline::from_fn(|i| {
            Inline::from_fn(|j| dot(&gradient.as_ref()[i], &forces.as_ref()[j]))
        });
        straight.then_some(Self {
            gradient,
            input: forces,
            compliance,
        })
    }
}

impl<M: Model<N>, const N: usize> Constants<M, N> {
    /// B_S G_SS⁻¹ column by column for the contacts that stick; `None` if G_SS is singular.
    pub(super) fn levers(&self, modes: &Modes<M, N>) -> Option<M::PerContact<[f64; N]>> {
        let stuck = |i: usize| modes.as_slice()[i] == Mode::Stick;
        let mut levers: M::PerContact<[f64; N]> = Inline::from_fn(|_| [0.0; N]);
        for column in modes.sticking() {
            let unit = Inline::from_fn(|i| f64::from(i == column));
            let push = solve::<M, f64, N>(self.compliance, unit, stuck)?;
            for row in modes.sticking() {
                let force = push.as_ref()[row];
                for (entry, b) in levers.as_mut()[column]
                    .iter_mut()
                    .zip(&self.input.as_ref()[row])
                {
                    *entry += b * force;
                }
            }
        }
        Some(levers)
    }
}

/// The value, if no derivative of it is other than zero.
fn flat<L: Lanes<N>, const N: usize>(number: &L) -> Option<f64> {
    let (state, design) = number.slopes();
    let constant = state.iter().all(|s| *s == 0.0) && design == 0.0;
    (constant && number.re().is_finite()).then_some(number.re())
}

/// A number without meaning in (0, 1), another for each index.
fn generic(index: usize, seed: f64) -> f64 {
    0.1 + 0.8 * (seed + 0.618_033_988_749_895 * (index + 1) as f64).fract()
}

fn generic_state<M: Model<N>, const N: usize>(seed: f64) -> [f64; N] {
    std::array::from_fn(|i| {
        let start = M::INFO.states.get(i).map_or(0.0, |state| state.start);
        start + (1.0 + start.abs()) * generic(i, seed)
    })
}

pub(super) fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

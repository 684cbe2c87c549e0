//! Friction along the way of a press that does not give way: while that rests, both hold one and the same motion.
//!
//! Which of them holds how much is not determined, and does not matter: with Q what else drives the mass against the wall,
//! friction up to its limit S holds as long as Q ≥ −S, whatever its share was before. It is therefore taken at that limit,
//! against the press opening, and the reaction Q + S vanishes where the motion goes on.

use super::affine::{Square, input, speed_rates};
use super::mode::Modes;
use super::rule::Branches;
use crate::field::generic::{GENERIC, generic_state};
use crate::model::Model;
use crate::scalar::{Inline, Lanes};

/// Relative difference of gradients that is rounding error.
const SAME: f64 = 1e-10;

/// Which contacts have no relative speed wherever the gap of which press stays as it is, as generic states show.
pub(super) fn ties<M: Model<N>, const N: usize>(
    lanes: &M::Params<M::Lanes>,
    plain: &M::Params<f64>,
) -> Square<M, bool, N> {
    let rubbing = M::INFO.contacts.len();
    let tied = |contact: usize, press: usize| {
        contact < rubbing
            && M::INFO.is_rigid(press)
            && M::INFO.rubs_under(press).all(|under| under != contact)
            && GENERIC.iter().all(|seed| {
                let state = generic_state::<M, N>(*seed);
                moves_with::<M, N>((lanes, plain), &state, contact, press)
            })
    };
    Inline::from_fn(|contact| Inline::from_fn(|press| tied(contact, press)))
}

/// Whether w = c ġ near a state, as it is once the rate of the gap is taken out of it: then w vanishes, and its gradient is
/// that of ġ but for a factor.
fn moves_with<M: Model<N>, const N: usize>(
    (lanes, plain): (&M::Params<M::Lanes>, &M::Params<f64>),
    state: &[f64; N],
    contact: usize,
    press: usize,
) -> bool {
    let alone = Modes::<M, N>::resting_alone(press);
    let mut rule = Branches::<M, f64, N>::free(alone.as_slice());
    let _ = M::rhs(plain, *state, &mut rule);
    let (push, gives) = push::<M, N>(plain, state, press);
    let impulse = -rule.speed.as_ref()[press] / gives.as_ref()[press];
    let factor = gives.as_ref()[contact] / gives.as_ref()[press];
    let still: [f64; N] = crate::scalar::filled(|i| state[i] + impulse * push[i]);
    let at = crate::scalar::filled(|i| M::Lanes::state(still[i], i));
    let mut rule = Branches::<M, M::Lanes, N>::free(alone.as_slice());
    let _ = M::rhs(lanes, at, &mut rule);
    let [speed, rate] = [contact, press].map(|i| Linear::of(&rule.speed.as_ref()[i]));
    let moves = (speed.value - factor * rate.value).abs();
    factor != 0.0 && moves <= SAME * speed.terms(&still) && speed.is_multiple(&rate, factor)
}

/// A number with its derivatives.
struct Linear<const N: usize> {
    value: f64,
    slopes: [f64; N],
    design: f64,
}

impl<const N: usize> Linear<N> {
    fn of<L: Lanes<N>>(number: &L) -> Self {
        let (slopes, design) = number.slopes();
        Self {
            value: number.re(),
            slopes,
            design,
        }
    }

    fn terms(&self, state: &[f64; N]) -> f64 {
        let terms = self.slopes.iter().zip(state);
        terms.map(|(slope, y)| (slope * y).abs()).sum()
    }

    fn is_multiple(&self, other: &Self, factor: f64) -> bool {
        let own = || self.slopes.iter().chain([&self.design]);
        let size = own().fold(0.0, |most: f64, slope| most.max(slope.abs()));
        let pairs = own().zip(other.slopes.iter().chain([&other.design]));
        pairs
            .map(|(a, b)| (a - factor * b).abs())
            .all(|off| off <= SAME * size)
    }
}

/// How much the relative speed of a contact changes for each unit by which that of a gap does, by an impulse there.
pub(super) fn factor<M: Model<N>, const N: usize>(
    plain: &M::Params<f64>,
    state: &[f64; N],
    contact: usize,
    press: usize,
) -> f64 {
    let (_, rates) = push::<M, N>(plain, state, press);
    rates.as_ref()[contact] / rates.as_ref()[press]
}

/// What a unit force of a press adds to the states, and by that to the relative speeds and the rates of gaps.
fn push<M: Model<N>, const N: usize>(
    plain: &M::Params<f64>,
    state: &[f64; N],
    press: usize,
) -> ([f64; N], M::PerContact<f64>) {
    let alone = Modes::<M, N>::resting_alone(press);
    let push = input::<M, f64, N>(plain, state, &alone, press);
    let rates = speed_rates::<M, f64, N>(plain, state, &alone, &push);
    (push, rates)
}

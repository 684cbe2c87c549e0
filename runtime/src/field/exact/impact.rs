//! Impacts: a contact that does not give way turns the speed of its approach by an impulse along its reaction.

use num_dual::Dual;

use super::system::ExactSystem;
use crate::friction::{ContactRule, FrictionLaw};
use crate::model::Model;
use crate::press::PressLaw;
use crate::scalar::{Inline, Lanes, Scalar};

/// An impact over any scalar.
pub(crate) struct Impact<D, const N: usize> {
    /// The state after it.
    pub(crate) state: [D; N],
    /// Speed at which the gap closed.
    pub(crate) approach: D,
    /// Speed at which it opens.
    pub(crate) departure: D,
    /// What a unit impulse adds to the rate of the gap: positive if a reaction parts the bodies.
    pub(crate) compliance: D,
}

impl<M: Model<N>, const N: usize> ExactSystem<M, N> {
    /// The impact of a press at a state.
    pub(crate) fn impact(&self, state: &[f64; N], press: usize) -> Impact<f64, N> {
        impact::<M, f64, N>(&self.plain, state, press)
    }

    /// The same with derivatives by the states and the design variable.
    pub(crate) fn linear_impact(&self, state: &[f64; N], press: usize) -> Impact<M::Lanes, N> {
        let lanes = std::array::from_fn(|i| M::Lanes::state(state[i], i));
        impact::<M, M::Lanes, N>(&self.lanes, &lanes, press)
    }

    /// What a unit impulse of one press adds to the rate of the gap of another.
    pub(crate) fn acts_on(&self, state: &[f64; N], press: usize, other: usize) -> bool {
        let push = push::<M, f64, N>(&self.plain, state, press);
        response::<M, f64, N>(&self.plain, state, &push, other) != 0.0
    }
}

/// y⁺ = y + B p with p = (v⁺ + v⁻)/G: B is the column of the reaction in the equations, G what it does to the rate of the
/// gap.
fn impact<M: Model<N>, D: Scalar, const N: usize>(
    params: &M::Params<D>,
    state: &[D; N],
    press: usize,
) -> Impact<D, N> {
    let mut rule = Reaction::of(press, D::from(0.0));
    let _ = M::rhs(params, *state, &mut rule);
    let (approach, departure) = (-rule.rate, rule.rebound);
    let push = push::<M, D, N>(params, state, press);
    let compliance = response::<M, D, N>(params, state, &push, press);
    let impulse = (approach + departure) / compliance;
    Impact {
        state: std::array::from_fn(|i| state[i] + push[i] * impulse),
        approach,
        departure,
        compliance,
    }
}

/// B: what a unit reaction adds to the field.
fn push<M: Model<N>, D: Scalar, const N: usize>(
    params: &M::Params<D>,
    state: &[D; N],
    press: usize,
) -> [D; N] {
    let still = |x: D| Dual::new(x, D::from(0.0));
    let lifted = Inline::from_fn(|i| still(params.as_ref()[i]));
    let unit = Dual::new(D::from(0.0), D::from(1.0));
    let field = M::rhs(&lifted, state.map(still), &mut Reaction::of(press, unit));
    field.map(|f| f.eps)
}

/// How fast the rate of a gap changes as the state moves along `direction`.
fn response<M: Model<N>, D: Scalar, const N: usize>(
    params: &M::Params<D>,
    state: &[D; N],
    direction: &[D; N],
    press: usize,
) -> D {
    let lifted = Inline::from_fn(|i| Dual::new(params.as_ref()[i], D::from(0.0)));
    let moving = std::array::from_fn(|i| Dual::new(state[i], direction[i]));
    let mut rule = Reaction::of(press, Dual::new(D::from(0.0), D::from(0.0)));
    let _ = M::rhs(&lifted, moving, &mut rule);
    rule.rate.eps
}

/// One reaction is given; what its gap does is noted. No other force matters: none depends on it.
struct Reaction<D> {
    press: usize,
    given: D,
    rate: D,
    rebound: D,
}

impl<D: Scalar> Reaction<D> {
    fn of(press: usize, given: D) -> Self {
        Self {
            press,
            given,
            rate: D::from(0.0),
            rebound: D::from(0.0),
        }
    }
}

impl<D: Scalar> ContactRule<D> for Reaction<D> {
    fn force<L: FrictionLaw<D>>(&mut self, _: usize, _: &L, _: D) -> D {
        D::from(0.0)
    }

    fn press<L: PressLaw<D>>(&mut self, contact: usize, law: &L, _: D, rate: D) -> D {
        if contact != self.press {
            return D::from(0.0);
        }
        self.rate = rate;
        self.rebound = law.rebound(-rate);
        self.given
    }
}

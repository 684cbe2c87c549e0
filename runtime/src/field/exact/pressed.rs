//! What is asked of the laws of presses beside their forces.

use num_dual::Dual64;

use crate::field::generic::generic_state;
use crate::friction::{ContactRule, FrictionLaw};
use crate::model::Model;
use crate::press::{PressLaw, Pressed};
use crate::scalar::{Inline, mapped};

/// Two depths that add nothing to each other's slopes unless these have a root at zero.
const SHALLOW: [f64; 2] = [1e-100, 1e-20];

/// The magnitude of the terms of what holds a press closed.
pub(super) fn hold_terms<M: Model<N>, const N: usize>(
    params: &M::Params<f64>,
    state: &[f64; N],
    press: usize,
) -> f64 {
    let mut rule = Terms { press, terms: 0.0 };
    let _ = M::rhs(params, *state, &mut rule);
    rule.terms
}

/// Notes the terms of what holds one press closed.
struct Terms {
    press: usize,
    terms: f64,
}

impl ContactRule<f64> for Terms {
    fn force<L: FrictionLaw<f64>>(&mut self, _: usize, _: &L, _: f64) -> f64 {
        0.0
    }

    fn press<L: PressLaw<f64>>(&mut self, contact: usize, law: &L, gap: f64, rate: f64) -> f64 {
        if contact == self.press {
            self.terms = Pressed::new(law, gap, rate).terms;
        }
        0.0
    }
}

/// Which presses have a force that is no power series in the depth: its slope changes between two depths so small that it
/// could not.
pub(super) fn rough<M: Model<N>, const N: usize>(
    params: &M::Params<Dual64>,
) -> M::PerContact<bool> {
    let mut rule = Roots::<M, N>(Inline::from_fn(|_| false));
    if !M::INFO.presses.is_empty() {
        let state = mapped(&generic_state::<M, N>(0.5), Dual64::from);
        let _ = M::rhs(params, state, &mut rule);
    }
    rule.0
}

/// Notes which forces have a root at depth zero.
struct Roots<M: Model<N>, const N: usize>(M::PerContact<bool>);

impl<M: Model<N>, const N: usize> ContactRule<Dual64> for Roots<M, N> {
    fn force<L: FrictionLaw<Dual64>>(&mut self, _: usize, _: &L, _: Dual64) -> Dual64 {
        Dual64::from(0.0)
    }

    fn press<L: PressLaw<Dual64>>(
        &mut self,
        press: usize,
        law: &L,
        _: Dual64,
        _: Dual64,
    ) -> Dual64 {
        let slope = |depth: f64| {
            let still = law.force(Dual64::from(depth), Dual64::from(0.0)).eps;
            law.force(Dual64::from(depth).derivative(), Dual64::from(0.0))
                .eps
                - still
        };
        let [touch, beyond] = SHALLOW.map(slope);
        if let Some(place) = self.0.as_mut().get_mut(press) {
            *place = touch != beyond;
        }
        Dual64::from(0.0)
    }
}

//! What the laws of all contacts do at rest, whatever the modes.

use num_dual::Dual64;

use crate::field::generic::{GENERIC, generic_state};
use crate::friction::{ContactRule, FrictionLaw};
use crate::model::Model;
use crate::press::{PressLaw, pressing};
use crate::scalar::{Inline, Scalar, mapped};

/// Speed within which each sliding force changes by as much as itself: slip(0⁺)/|slip'(0⁺)|.
pub(super) fn layers<M: Model<N>, const N: usize>(
    params: &M::Params<Dual64>,
    state: &[f64; N],
) -> M::PerContact<f64> {
    let mut rule = Layers::<M, N>(Inline::from_fn(|_| f64::INFINITY));
    let _ = M::rhs(params, mapped(state, Dual64::from), &mut rule);
    rule.0
}

/// Which contacts hold with no force and slide against none at w = 0, shown at generic states; `params` move with the
/// design variable, and must leave it so.
///
/// A sliding force is continued to the other side of w = 0 as an odd function, so that such a contact needs no switch.
pub(super) fn idle<M: Model<N>, const N: usize>(params: &M::Params<Dual64>) -> M::PerContact<bool> {
    unloaded::<M, N>(params, &|_| Some(1.0))
}

fn unloaded<M: Model<N>, const N: usize>(
    params: &M::Params<Dual64>,
    press: &dyn Fn(usize) -> Option<f64>,
) -> M::PerContact<bool> {
    let at = GENERIC.map(|seed| {
        let state = mapped(&generic_state::<M, N>(seed), Dual64::from);
        limits::<M, Dual64, N>(params, &state, press)
    });
    let none = |force: Dual64| (force.re, force.eps) == (0.0, 0.0);
    Inline::from_fn(|i| {
        let mut limits = at.iter().map(|limits| limits.as_ref()[i]);
        let rubs = i < M::INFO.contacts.len();
        rubs && limits.all(|(stick, slip)| none(stick) && none(slip))
    })
}

/// Which contacts hold with no force and slide against none while these presses are open, shown at generic states.
pub(super) fn loose<M: Model<N>, const N: usize>(
    params: &M::Params<Dual64>,
    open: impl Fn(usize) -> bool,
) -> M::PerContact<bool> {
    unloaded::<M, N>(params, &|press| Some(f64::from(u8::from(!open(press)))))
}

/// stick and slip(0⁺) of every contact, each press with the force that it is given, or as its law says.
pub(super) fn limits<M: Model<N>, D: Scalar, const N: usize>(
    params: &M::Params<D>,
    state: &[D; N],
    press: &dyn Fn(usize) -> Option<f64>,
) -> M::PerContact<(D, D)> {
    let zero = D::from(0.0);
    let mut rule = AtRest::<M, D, N> {
        limits: Inline::from_fn(|_| (zero, zero)),
        press,
    };
    let _ = M::rhs(params, *state, &mut rule);
    rule.limits
}

/// Notes the largest force at rest and the limit of the sliding force at speed 0.
struct AtRest<'a, M: Model<N>, D: Scalar, const N: usize> {
    limits: M::PerContact<(D, D)>,
    press: &'a dyn Fn(usize) -> Option<f64>,
}

impl<M: Model<N>, D: Scalar, const N: usize> ContactRule<D> for AtRest<'_, M, D, N> {
    fn force<L: FrictionLaw<D>>(&mut self, contact: usize, law: &L, _: D) -> D {
        let zero = D::from(0.0);
        if let Some(place) = self.limits.as_mut().get_mut(contact) {
            *place = (law.stick(), law.slip(zero));
        }
        zero
    }

    fn press<L: PressLaw<D>>(&mut self, contact: usize, law: &L, gap: D, rate: D) -> D {
        (self.press)(contact).map_or_else(|| pressing(law, gap, rate), D::from)
    }
}

/// Notes how fast every sliding force changes at speed 0.
struct Layers<M: Model<N>, const N: usize>(M::PerContact<f64>);

impl<M: Model<N>, const N: usize> ContactRule<Dual64> for Layers<M, N> {
    fn force<L: FrictionLaw<Dual64>>(&mut self, contact: usize, law: &L, _: Dual64) -> Dual64 {
        let slip = law.slip(Dual64::from(0.0).derivative());
        let layer = (slip.re / slip.eps).abs();
        if let (Some(place), true) = (self.0.as_mut().get_mut(contact), layer > 0.0) {
            *place = layer;
        }
        Dual64::from(0.0)
    }
}

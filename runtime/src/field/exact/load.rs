//! How friction grows with the reaction that presses it.

use num_dual::Dual64;

use crate::field::generic::{GENERIC, generic_state};
use crate::friction::{ContactRule, FrictionLaw};
use crate::model::Model;
use crate::press::PressLaw;
use crate::scalar::{Inline, mapped};

/// A contact whose friction is no affine function of the reaction of a press that does not give way, and that press.
pub(super) fn bent<M: Model<N>, const N: usize>(
    params: &M::Params<Dual64>,
) -> Option<(usize, usize)> {
    let state = mapped(&generic_state::<M, N>(GENERIC[0]), Dual64::from);
    let rigid = |press: &usize| M::INFO.is_rigid(*press);
    let presses = (0..M::INFO.contacts.len() + M::INFO.presses.len()).filter(rigid);
    let slopes = |press: usize, force: f64| {
        let mut rule = UnderLoad::<M, N> {
            press,
            force: Dual64::new(force, 1.0),
            slopes: Inline::from_fn(|_| [0.0; 3]),
        };
        let _ = M::rhs(params, state, &mut rule);
        rule.slopes
    };
    presses
        .flat_map(|press| M::INFO.rubs_under(press).map(move |i| (i, press)))
        .find(|(i, press)| {
            let [light, heavy] = LOADS.map(|force| slopes(*press, force).as_ref()[*i]);
            let same = |(a, b): (&f64, &f64)| (a - b).abs() <= STRAIGHT * (a.abs() + b.abs());
            !light.iter().zip(&heavy).all(same)
        })
}

/// Two reactions, and the relative difference of slopes between them that is rounding error.
const LOADS: [f64; 2] = [0.3, 2.9];
const STRAIGHT: f64 = 1e-10;

/// Notes how the friction of each contact grows with one reaction: at rest, at speed 0 and while sliding.
struct UnderLoad<M: Model<N>, const N: usize> {
    press: usize,
    force: Dual64,
    slopes: M::PerContact<[f64; 3]>,
}

impl<M: Model<N>, const N: usize> ContactRule<Dual64> for UnderLoad<M, N> {
    fn force<L: FrictionLaw<Dual64>>(&mut self, contact: usize, law: &L, speed: Dual64) -> Dual64 {
        let still = Dual64::from(0.0);
        let forces = [
            law.stick(),
            law.slip(still),
            law.slip(Dual64::from(speed.re.abs())),
        ];
        if let Some(place) = self.slopes.as_mut().get_mut(contact) {
            *place = mapped(&forces, |force| force.eps);
        }
        still
    }

    fn press<L: PressLaw<Dual64>>(&mut self, press: usize, _: &L, _: Dual64, _: Dual64) -> Dual64 {
        if press == self.press {
            self.force
        } else {
            Dual64::from(0.0)
        }
    }
}

/// How the friction of each contact grows with the reaction of a press: at speed 0, and at the speed that it has.
pub(super) fn grips<M: Model<N>, const N: usize>(
    params: &M::Params<Dual64>,
    state: &[f64; N],
    press: usize,
) -> M::PerContact<[f64; 2]> {
    let mut rule = UnderLoad::<M, N> {
        press,
        force: Dual64::new(1.0, 1.0),
        slopes: Inline::from_fn(|_| [0.0; 3]),
    };
    let _ = M::rhs(params, mapped(state, Dual64::from), &mut rule);
    Inline::from_fn(|i| [rule.slopes.as_ref()[i][1], rule.slopes.as_ref()[i][2]])
}

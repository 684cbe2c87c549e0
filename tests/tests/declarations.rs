//! What `model!` and `friction_law!` make of a declaration, as data and as numbers.

use stickslip::friction::{ContactRule, FrictionLaw};
use stickslip::model::Model;
use stickslip::scalar::Scalar;
use stickslip_models::{BeltOscillator, BeltPair, DrillString, VanDerPol};

/// Every contact slides towards negative speeds.
struct Backward(Vec<usize>);

impl<D: Scalar> ContactRule<D> for Backward {
    fn force<L: FrictionLaw<D>>(&mut self, contact: usize, law: &L, speed: D) -> D {
        self.0.push(contact);
        law.slip(-speed)
    }
}

#[test]
fn right_sides_are_as_written() {
    let mut rule = Backward(Vec::new());
    let belt = BeltOscillator {
        m: 2.0,
        ..Default::default()
    };
    let f = BeltOscillator::rhs(&belt.values(), [0.5, 0.1], &mut rule);
    assert_eq!(f, [0.1, (1.0 / (1.0 + 3.0 * -(0.1 - 0.2)) - 0.5) / 2.0]);
    let f = VanDerPol::rhs(&[2.0], [0.5, 0.1], &mut rule);
    assert_eq!(f, [0.1, -2.0 * (0.5 * 0.5 - 1.0) * 0.1 - 0.5]);
    rule.0.clear();
    BeltPair::rhs(&BeltPair::default().values(), [0.0; 4], &mut rule);
    assert_eq!(rule.0, [0, 1]);
    let f = DrillString::rhs(&[4.0, 4.2, 3.0, 0.05], [0.5, 0.1], &mut rule);
    assert_eq!(f, [0.1, -2.0 * 0.05 * 0.1 - 0.5 - (3.0 + 3.0)]);
}

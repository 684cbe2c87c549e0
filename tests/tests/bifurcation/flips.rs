//! On which side of a flip the doubled orbit lies.

use stickslip::continuation::Kind;
use stickslip::model;
use stickslip::study::{Case, System};
use stickslip_models::friction::CoulombStatic;

model! {
    /// Two blocks on a belt with a static peak: after Galvanetto and Bishop 1994.
    struct Galvanetto {
        state x = 1.0;
        state v = 0.0;
        state y = 0.3;
        state u = 0.0;
        param belt = 0.1;
        param k = 1.2;
        param kin = 0.6 where 0.0 <= kin <= 1.0;
        param second = 1.3;
        friction F = CoulombStatic { static_level: 1.0, kinetic_level: kin } opposing v - belt;
        friction G = CoulombStatic { static_level: second, kinetic_level: kin * second } opposing u - belt;
        der(x) = v;
        der(v) = F - x - k * (x - y) - 0.05 * v;
        der(y) = u;
        der(u) = G - y - k * (y - x) - 0.05 * u;
    }
}

/// Whatever the accuracy: next to the flip a doubled orbit lies on either side of it for its errors.
#[test]
fn a_subcritical_flip_is_called_so() {
    for accuracy in [1e-5, 1e-7, 1e-9] {
        let mut case = Case::of(&Galvanetto::default()).following(Galvanetto::second, 1.5..1.3);
        case.parameters[Galvanetto::second.index] = 1.5;
        case.accuracy = accuracy;
        let branch = System::of::<Galvanetto, _>().branch(&case).unwrap();
        let flip = branch.special.iter().find(|one| one.kind == Kind::Flip);
        let flip = flip.unwrap_or_else(|| panic!("{:?}", branch.ended.reason));
        assert!((flip.r - 1.364_274_84).abs() <= flip.error.unwrap() + 1e-8);
        assert_eq!(flip.criticality, Some("subcritical"), "{accuracy:e}");
    }
}

//! Contacts that move alike: in which order they switch is left to rounding, and tells nothing.

use stickslip::continuation::Kind;
use stickslip::model;
use stickslip::study::{Case, System};
use stickslip_models::friction::CoulombStatic;

model! {
    /// Two pendula with dry pivots on a beam that shakes.
    struct Pendula {
        state a: rad = 0.6;
        state b: rad = -0.3;
        state wa: rad/s = 0.0;
        state wb: rad/s = 0.0;
        param spring: 1/s^2 = 1.5;
        param dry: 1/s^2 = 0.15 where dry >= 0.0;
        param damping: 1/s = 0.02 where damping >= 0.0;
        param shake: 1 = 0.08;
        param omega: rad/s = 3.0 where omega > 0.0;
        drive phi at omega;
        let base = shake * powi(omega, 2) * cos(phi);
        friction Fa: 1/s^2 = CoulombStatic { static_level: 1.3 * dry, kinetic_level: dry } opposing wa;
        friction Fb: 1/s^2 = CoulombStatic { static_level: 1.3 * dry, kinetic_level: dry } opposing wb;
        der(a) = wa;
        der(b) = wb;
        der(wa) = Fa - 9.81 * sin(a) - spring * (a - b) - damping * wa + base * cos(a);
        der(wb) = Fb - 9.81 * sin(b) - spring * (b - a) - damping * wb + base * cos(b);
    }
}

/// They swing as one, and turn back as one; next to where they cease to, they are apart by what is left of Newton's steps,
/// now the one and now the other is first, which was told as seventeen vanishing segments.
#[test]
fn what_moves_alike_does_not_change_its_order() {
    let case = Case::of(&Pendula::default()).following(Pendula::shake, 0.08..0.06);
    let branch = System::of::<Pendula, _>().branch(&case).unwrap();
    assert_eq!(branch.ended.word(), "reached-end");
    let kinds: Vec<Kind> = branch.special.iter().map(|one| one.kind).collect();
    assert_eq!(kinds, [Kind::SymmetryBreaking], "{:?}", branch.special);
}

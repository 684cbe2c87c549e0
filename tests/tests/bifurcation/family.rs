//! Where r stands still and orbits go on changing.

use stickslip::continuation::Kind;
use stickslip::model;
use stickslip::study::{Case, System};
use stickslip_models::friction::Coulomb;
use stickslip_models::press::Compliant;

model! {
    /// A hammer drives a bit that dry friction holds.
    struct Drill {
        state d = 0.02;
        state v = 0.0;
        state u = 0.0;
        param hold = 0.2 where hold >= 0.0;
        drive phi at 0.1;
        press N = Compliant { stiffness: 1.0, damping: 0.1 } closing d;
        friction F = Coulomb { level: hold } opposing u;
        der(d) = u - v;
        der(v) = 0.15 + 0.3 * cos(phi) - N;
        der(u) = (F + N) / 0.1;
    }
}

/// Held by what drives it in the mean, the bit gets on at any speed at which it never sticks: a family of orbits, of which
/// errors of a double multiplier 1 made up to forty branch points.
#[test]
fn what_slides_at_any_speed_has_no_branch_points() {
    for accuracy in [1e-7, 1e-9, 1e-10] {
        let mut case = Case::of(&Drill::default()).following(Drill::hold, 0.2..0.1);
        case.accuracy = accuracy;
        let branch = System::of::<Drill, _>().branch(&case).unwrap();
        assert_eq!(branch.ended.word(), "family", "{}", branch.ended.reason);
        let last = branch.special.last().unwrap();
        assert_eq!(last.kind, Kind::GrazingSliding);
        assert!((last.r - 0.15).abs() < 1e-9);
        let kinds = branch.special.iter().map(|one| one.kind);
        assert_eq!(kinds.filter(|kind| *kind == Kind::BranchPoint).count(), 0);
    }
}

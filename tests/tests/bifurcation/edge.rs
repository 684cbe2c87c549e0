//! The edge of a family of orbits.

use stickslip::bifurcation::Stability;
use stickslip::model;
use stickslip::study::{Case, System};
use stickslip_models::friction::CoulombStatic;

model! {
    /// Two masses on a slow belt that stick together for a while: how far apart is their own choice from there on (M. Pascal,
    /// Nonlinear Dynamics 68 (2012) 515).
    struct Pair {
        state x1 = 0.3;
        state v1 = 0.0;
        state x2 = 0.9;
        state v2 = 0.0;
        param belt = 0.12;
        friction F1 = CoulombStatic { static_level: 1.0, kinetic_level: 0.6 } opposing v1 - belt;
        friction F2 = CoulombStatic { static_level: 1.0, kinetic_level: 0.6 } opposing v2 - belt;
        der(x1) = v1;
        der(v1) = F1 - x1 - 0.7 * (x1 - x2);
        der(x2) = v2;
        der(v2) = F2 - x2 - 0.7 * (x2 - x1);
    }
}

/// Motions come to the edge from one side and stay where they are on the other: Newton's method halves the way to it each time,
/// and the multiplier 1 − 2e-7 that it ends with was told as stable.
#[test]
fn the_edge_of_a_family_is_not_stable_by_its_errors() {
    let case = Case::of(&Pair::default());
    if let Ok(orbit) = System::of::<Pair, _>().orbit(&case) {
        let nearest = orbit.floquet.multipliers[0].re - 1.0;
        assert!(nearest.abs() <= orbit.error_estimate, "{nearest:e}");
        assert_eq!(orbit.floquet.stability, Stability::Undecided);
    }
}

//! Special points at a parameter that is zero there are what they are at any other value of it.

use stickslip::model;
use stickslip::study::BranchRecord;
use stickslip_models::friction::Coulomb;
use stickslip_models::press::Rigid;
use stickslip_tests::branches::branch;

model! {
    /// Two neighbouring houses on flat sliders that pound, shaken at a frequency beside one that is given.
    struct Pounders {
        state x[2] = 0.0;
        state v[2] = 0.0;
        param base = 3.0;
        param beside = 0.0;
        drive phi at base + beside;
        press P = Rigid { restitution: 0.6 } closing 0.05 - x[0] + x[1];
        friction F = Coulomb { level: 0.05 * 9.81 } opposing v[0];
        friction G = Coulomb { level: 0.08 * 9.81 } opposing v[1];
        for i in 0..2 { der(x[i]) = v[i]; }
        der(v[0]) = F - 4.0 * x[0] - P - 2.0 * cos(phi);
        der(v[1]) = G - 10.0 * x[1] + 1.6 * P - 2.0 * cos(phi);
    }
}

/// The branch over the same frequencies, counted from another one.
fn counted_from(base: f64) -> BranchRecord {
    let range = (2.5 - base, 3.5 - base);
    branch(&[(Pounders::base, base)], Pounders::beside, range, |_| {})
}

#[test]
fn special_points_at_zero_are_those_of_elsewhere() {
    let frequencies = |base: f64| {
        let found = counted_from(base).special.into_iter();
        let mut all: Vec<_> = found
            .map(|one| (one.kind, base + one.r, one.error))
            .collect();
        all.sort_by(|a, b| a.1.total_cmp(&b.1));
        all
    };
    let usual = frequencies(0.0);
    assert!(usual.len() > 3, "{usual:?}");
    for (kind, there, _) in &usual {
        let shifted = frequencies(*there);
        assert_eq!(
            shifted.len(),
            usual.len(),
            "{kind:?} at {there}: {shifted:?}"
        );
        for (one, other) in usual.iter().zip(&shifted) {
            assert_eq!(one.0, other.0, "{kind:?} at {there}");
            let errors = one.2.unwrap() + other.2.unwrap();
            assert!((one.1 - other.1).abs() <= errors, "{one:?} {other:?}");
        }
    }
}

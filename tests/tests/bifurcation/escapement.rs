//! A symmetry that moves what runs on by half its turn.

use stickslip::continuation::Kind;
use stickslip::model;
use stickslip_models::friction::Coulomb;
use stickslip_models::press::Compliant;
use stickslip_tests::branches::branch;

model! {
    /// A wheel whose wave of three teeth pushes a balance through two pallets: half a tooth on, it pushes the other way.
    struct Escapement {
        state a = 0.3;
        state u = 0.0;
        state theta = 0.0;
        state w = 1.0;
        param torque = 0.6;
        let wave = 0.5 * sin(3.0 * theta);
        let slope = 1.5 * cos(3.0 * theta);
        press P = Compliant { stiffness: 20.0, damping: 0.2 } closing 0.2 - wave + a;
        press Q = Compliant { stiffness: 20.0, damping: 0.2 } closing 0.2 + wave - a;
        friction B = Coulomb { level: 0.05 } opposing u;
        der(a) = u;
        der(theta) = w;
        der(u) = P - Q - a - 0.05 * u + B;
        der(w) = (torque - slope * (P - Q) - 0.05 * w) / 0.2;
    }
}

/// The branch comes back as its own image, along the same values of the torque: it was a fold.
#[test]
fn what_turns_and_comes_back_mirrored_has_become_symmetric() {
    let found = branch::<Escapement, _>(&[], Escapement::torque, (0.6, 0.5), |_| {});
    let [first, last] = [found.points.first(), found.points.last()].map(Option::unwrap);
    assert_eq!((first.r, last.r), (Some(0.6), Some(0.6)));
    assert!((first.max[0] + last.min[0]).abs() < 1e-7);
    assert!((first.max[0] + first.min[0]).abs() > 0.01);
    let turns = |kind: Kind| {
        matches!(
            kind,
            Kind::Fold | Kind::SymmetryBreaking | Kind::BranchPoint
        )
    };
    let turned: Vec<_> = found.special.iter().filter(|one| turns(one.kind)).collect();
    let [lost] = turned[..] else {
        panic!("{turned:?}")
    };
    assert_eq!(lost.kind, Kind::SymmetryBreaking);
    // What is met on the way there is met on the way back.
    let others: Vec<_> = found
        .special
        .iter()
        .filter(|one| !turns(one.kind))
        .collect();
    for (there, back) in others.iter().zip(others.iter().rev()) {
        assert!((there.r - back.r).abs() <= there.error.unwrap() + back.error.unwrap());
    }
    // There and back, the asymmetry a_max + a_min grows with the root of the way from it.
    let asymmetry = |one: &&stickslip::study::OrbitRecord| (one.max[0] + one.min[0]).powi(2);
    let ways = found
        .points
        .iter()
        .filter(|one| one.r.unwrap() - lost.r > 1e-6);
    let near: Vec<_> = ways.filter(|one| one.r.unwrap() - lost.r < 5e-4).collect();
    assert!(near.len() > 3, "{}", near.len());
    let slope = asymmetry(&near[0]) / (near[0].r.unwrap() - lost.r);
    for one in near {
        let expected = slope * (one.r.unwrap() - lost.r);
        assert!((asymmetry(&one) / expected - 1.0).abs() < 0.2);
    }
}

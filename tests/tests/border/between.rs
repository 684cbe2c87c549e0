//! What drifts freely between two lines, and what slides along a surface for ever at one value of a parameter.

use stickslip::model;
use stickslip_models::friction::Coulomb;
use stickslip_models::press::Compliant;
use stickslip_tests::branches::branch;

model! {
    /// A pontoon between two mooring lines, swung by waves: with both lines slack it may be anywhere.
    struct Pontoon {
        state x = -0.1;
        state v = 0.0;
        param slack = 0.3;
        drive phi at 1.5;
        press A = Compliant { stiffness: 1.0, damping: 0.0 } closing slack - x;
        press B = Compliant { stiffness: 1.0, damping: 0.0 } closing slack + x;
        der(x) = v;
        der(v) = 0.2 * cos(phi) - 0.1 * v - A + B;
    }
}

model! {
    /// A relay that slides: s² + 2 sig s + 1 = 0 along its surface, so that all orbits there are periodic at sig = 0.
    struct Relay {
        state y = 1.0;
        state a = 0.0;
        state b = 0.0;
        param sig = -0.5;
        friction u = Coulomb { level: 1.0 } opposing y;
        der(y) = -1.1 * y + a + u;
        der(a) = -1.1 * y + b + 2.0 * sig * u;
        der(b) = -y + u;
    }
}

/// Half of what the pontoon swings by with both lines slack: 0.2/(ω √(ω² + 0.1²)) at ω = 1.5.
fn half() -> f64 {
    0.2 / (1.5 * 1.5_f64.hypot(0.1))
}

#[test]
fn a_line_that_tightens_holds_what_drifted() {
    let found = branch::<Pontoon, _>(&[], Pontoon::slack, (0.3, 0.1), |_| {});
    for point in &found.points {
        // An orbit that a line pulls at comes back to where it was; one that none does swings by as much as ever.
        let shift = point.shift.as_deref().unwrap_or(&[]);
        assert!(shift.iter().all(|gain| gain.abs() < 1e-9), "{shift:?}");
        let swing = 0.5 * (point.max[0] - point.min[0]);
        let slack = point.r.unwrap();
        let touches = point.min[0] < -slack || point.max[0] > slack;
        assert!(touches || (swing / half() - 1.0).abs() < 1e-8, "{swing}");
    }
    let named: Vec<_> = found.special.iter().map(|one| one.r).collect();
    let lowest = -found.points[0].min[0];
    assert!(named.iter().any(|r| (r - lowest).abs() < 1e-6), "{named:?}");
}

#[test]
fn a_family_at_zero_is_told_as_one() {
    let found = branch::<Relay, _>(&[], Relay::sig, (-0.5, 1.0), |_| {});
    assert!(
        found.ended.reason.contains("family"),
        "{}",
        found.ended.reason
    );
    let labels: Vec<_> = found.special.iter().map(|one| one.label.as_str()).collect();
    assert_eq!(labels, ["CS1", "AS1"]);
    assert!(found.special[1].r.abs() < 1e-9);
}

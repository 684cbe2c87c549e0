//! What friction holds on something that swings: where it lets go, and what is followed until then.

use stickslip::model;
use stickslip::study::{Case, Kind, OrbitRecord, System};
use stickslip_models::friction::Coulomb;
use stickslip_tests::branches::branch;

model! {
    /// Torsion behind a cardan joint (after Asokanthan and Meehan 2000): the shaft sticks to a joint that swings.
    struct Cardan {
        state angle = 0.0;
        state w = 0.0;
        param inertia = 0.05 where inertia > 0.0;
        param k = 2000.0;
        param bend = 0.1;
        param hold = 3.0 where hold >= 0.0;
        drive phi at 60.0;
        let joint = bend * bend / 4.0 * sin(2.0 * phi);
        let rate = bend * bend * 30.0 * cos(2.0 * phi);
        friction F = Coulomb { level: hold } opposing w - rate;
        friction B = Coulomb { level: 2.0 } opposing w + 60.0;
        der(angle) = w;
        der(w) = (F + B + k * (joint - angle) + 0.3 * (rate - w)) / inertia;
    }
}

model! {
    /// A nonlinear energy sink with dry friction on a driven mass (after Gendelman, Starosvetsky, Feldman 2008).
    struct Sink {
        state x = 0.0;
        state y = 0.0;
        state v = 0.0;
        state u = 0.0;
        param omega = 0.7 where omega > 0.0;
        drive phi at omega;
        friction F = Coulomb { level: 0.001 } opposing u - v;
        let pull = 0.0666 * powi(x - y, 3) + 0.01 * (v - u);
        der(x) = v;
        der(y) = u;
        der(v) = 0.015 * cos(phi) - x - 0.02 * v - pull - F;
        der(u) = (pull + F) / 0.05;
    }
}

/// J ω² β² is the most that friction bears: the load by which it holds more the one way is balanced.
#[test]
fn a_shaft_lets_go_of_its_joint_at_one_bend_either_way() {
    let expected = (3.0_f64 / (0.05 * 3600.0)).sqrt();
    for (from, to) in [(0.05, 0.15), (0.15, 0.05)] {
        let branch = branch(&[], Cardan::bend, (from, to), |_| {});
        let special = &branch.special;
        let lets_go = special
            .iter()
            .find(|one| one.kind == Kind::VanishingSegment);
        let off = lets_go.map(|one| (one.r - expected).abs());
        assert!(off.is_some_and(|off| off < 1e-7), "{from}: {special:?}");
        let last = branch.points.last().unwrap().r.unwrap();
        assert!((last - to).abs() < 1e-12, "{}", branch.ended.reason);
    }
}

/// A spring without a linear part does not tell its middle: the place stays where it is, as long as friction bears ω² X there.
#[test]
fn a_sink_is_held_where_it_is_until_it_lets_go() {
    let branch = branch(&[], Sink::omega, (0.7, 0.8), |_| {});
    let bears = |omega: f64| {
        let square = omega * omega;
        square * 0.015 / (1.0 - 1.05 * square).hypot(0.02 * omega) - 0.02
    };
    let (mut low, mut high) = (0.7, 0.8);
    for _ in 0..50 {
        let middle = f64::midpoint(low, high);
        if bears(middle) > 0.0 {
            high = middle;
        } else {
            low = middle;
        }
    }
    let first = &branch.special[0];
    assert!((first.r - low).abs() < 1e-5, "{first:?}");
    let held = |one: &&OrbitRecord| one.r.unwrap() < low + 1e-5;
    let stays = |one: &OrbitRecord| one.word.as_deref() == Some("stick(F)");
    assert!(branch.points.iter().filter(held).count() > 3);
    assert!(branch.points.iter().filter(held).all(stays));
    // Beyond, it slides to and fro, as the orbit does on which its motion settles.
    let last = branch.points.last().unwrap();
    let case = Case {
        accuracy: 1e-9,
        ..Case::of(&Sink { omega: 0.8 })
    };
    let settled = System::of::<Sink, _>().orbit(&case).unwrap();
    assert_eq!((last.r, &last.word), (Some(0.8), &settled.word));
    for (found, known) in last.max_abs.iter().zip(&settled.max_abs) {
        assert!((found - known).abs() < 1e-6 * known, "{found} {known}");
    }
}

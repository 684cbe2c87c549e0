//! What friction holds all along until the force on it is more than it bears, in closed form.

use stickslip::continuation::Kind;
use stickslip::model;
use stickslip::study::{BranchRecord, Special};
use stickslip_models::friction::{Coulomb, Tustin};
use stickslip_tests::branches::branch;

model! {
    /// A quarter of a car on a road, its leaf spring rubbing.
    struct Leaf {
        state zs = 0.3;
        state vs = 0.0;
        state zu = 0.0;
        state vu = 0.0;
        param level = 1.0 where level >= 0.0;
        param road = 1.0;
        drive phi at 1.3;
        friction F = Coulomb { level } opposing vs - vu;
        let spring = zs - zu + 0.4 * (vs - vu);
        der(zs) = vs;
        der(vs) = F - spring;
        der(zu) = vu;
        der(vu) = (spring - F - 10.0 * (zu - road * cos(phi)) - 0.05 * vu) / 0.13;
    }
}

model! {
    /// A mass on a spring and a damper, on a table that is moved to and fro: held, it moves with that, about any place.
    struct Table {
        state x = 0.1;
        state v = 0.0;
        param amp = 0.2;
        drive phi at 2.0;
        friction F = Coulomb { level: 1.0 } opposing v - 2.0 * amp * cos(phi);
        der(x) = v;
        der(v) = F - x - 0.3 * v;
    }
}

model! {
    /// A clutch of two plates: the second, which sticks all along, bears most as the first ceases to slide.
    struct Clutch {
        state d1 = 0.0;
        state w1 = 10.0;
        state d2 = 0.0;
        state w2 = 10.0;
        param engine = 8.0;
        friction T1 = Tustin { static_level: 80.0, kinetic_level: 60.0, speed: 3.0, viscous: 0.0 } opposing w1 - engine;
        friction T2 = Tustin { static_level: 80.0, kinetic_level: 60.0, speed: 3.0, viscous: 0.0 } opposing w2 - w1;
        der(d1) = w1;
        der(d2) = w2;
        der(w1) = (T1 - T2 - 1000.0 * d1 - 0.05 * w1) / 0.01;
        der(w2) = (T2 - 400.0 * d2 - 0.05 * w2) / 0.02;
    }
}

/// Held, all of it moves as one mass of 1.13 by 10 road/|10 − 1.13 ω² + 0.05 i ω|, and F = ω² times that swings about nothing where
/// it bears as much the one way as the other.
fn road_over_level() -> f64 {
    let square = 1.3 * 1.3;
    f64::hypot(10.0 - 1.13 * square, 0.05 * 1.3) / (10.0 * square)
}

/// Where all slides vanish, or set in, of what does so nearest to this; and that the branch comes to the end of its range.
fn lets_go(record: &BranchRecord, end: f64, right: f64) -> f64 {
    let last = record.points.last().and_then(|point| point.r);
    assert_eq!(last, Some(end), "{:?}", record.ended);
    let vanishing = |one: &&Special| one.kind == Kind::VanishingSegment;
    let found = record.special.iter().filter(vanishing).map(|one| one.r);
    let off = |r: &f64| (r - right).abs();
    let nearest = found.min_by(|a, b| off(a).total_cmp(&off(b)));
    nearest.expect("it lets go")
}

/// From a state of rest, too, at which nothing swings. Beyond, orbits that slide one way only by what rounding leaves of it are none.
#[test]
fn a_spring_lets_go_and_holds_again_where_the_closed_form_says() {
    let roads = [(0.0, 2.0), (0.05, 2.0), (2.0, 0.05)];
    let levels = [(0.1, 10.0), (10.0, 0.1)];
    let road = roads.map(|range| (Leaf::road, range, road_over_level()));
    let level = levels.map(|range| (Leaf::level, range, 1.0 / road_over_level()));
    for (along, range, right) in road.into_iter().chain(level) {
        for accuracy in [1e-9, 1e-6] {
            let record = branch(&[], along, range, |case| case.accuracy = accuracy);
            let found = lets_go(&record, range.1, right);
            assert!(
                (found / right - 1.0).abs() < 100.0 * accuracy.max(1e-8),
                "{range:?} at {accuracy:e}: {found} for {right}"
            );
        }
    }
}

/// What friction held in any place does not change what the borders beyond are.
#[test]
fn borders_are_the_same_beyond_where_friction_has_held() {
    let kinds = |range| {
        let record = branch(&[], Leaf::level, range, |_| ());
        let kinds = record.special.iter().map(|one| one.kind);
        kinds.collect::<Vec<_>>()
    };
    let mut back = kinds((10.0, 0.1));
    back.reverse();
    assert_eq!(kinds((0.1, 10.0)), back);
}

/// F = (1 − ω²) A sin φ + 0.3 ω A cos φ + d: it bears as much the one way as the other where d = 0.
#[test]
fn what_is_held_may_move_with_a_drive() {
    let right = 1.0 / f64::hypot(3.0, 0.6);
    for range in [(0.1, 0.6), (0.6, 0.1)] {
        let record = branch(&[], Table::amp, range, |_| ());
        let found = lets_go(&record, range.1, right);
        assert!(
            (found / right - 1.0).abs() < 1e-6,
            "{range:?}: {found} for {right}"
        );
    }
    let held = &branch(&[], Table::amp, (0.1, 0.2), |_| ()).points[0].held;
    assert!(
        held.len() == 1 && held[0].combination == "x" && !held[0].conserved,
        "{held:?}"
    );
}

/// When that is depends on where the motion begins: without it the branch stood still near 7.7.
#[test]
fn a_force_may_be_largest_as_another_contact_switches() {
    let record = branch(&[], Clutch::engine, (8.0, 0.1), |_| ());
    let last = record.points.last().and_then(|point| point.r);
    assert_eq!(last, Some(0.1), "{:?}", record.ended);
    assert!(record.points.len() < 100, "{}", record.points.len());
}

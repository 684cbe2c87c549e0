//! What is told of folds: their periods, and none where only rounding turns a branch.

use std::f64::consts::TAU;

use stickslip::continuation::{Ending, Kind};
use stickslip::model;
use stickslip::study::{Case, Dynamics, OrbitRecord, Special, System};
use stickslip_models::BeltPair;
use stickslip_models::friction::{Coulomb, Tustin, Weakening};
use stickslip_models::press::Hertz;
use stickslip_tests::branches::{branch, named};

model! {
    /// A weak motor that turns an unbalance on a foundation that rubs: Sommerfeld.
    struct Sommerfeld {
        state x: m = 0.0;
        state v: m/s = 0.0;
        state a: rad = 0.0;
        state w: rad/s = 8.0;
        param torque: N*m = 0.5;
        friction F: N = Coulomb { level: 1.0 } opposing v;
        let det = 10.0 * 0.05 - 0.05 * 0.05 * sin(a) * sin(a);
        let force = F - 1000.0 * x - 5.0 * v + 0.05 * w * w * cos(a);
        let driving = torque - 0.05 * w;
        der(x) = v;
        der(v) = (0.05 * force + 0.05 * sin(a) * driving) / det;
        der(a) = w;
        der(w) = (0.05 * sin(a) * force + 10.0 * driving) / det;
    }
}

model! {
    /// A servo drive whose integral control hunts against friction.
    struct Servo {
        state e: rad = 0.1;
        state w: rad/s = 0.0;
        state i: rad*s = 0.0;
        param kd: N*m*s/rad = 0.1;
        friction F: N*m = Tustin { static_level: 0.3, kinetic_level: 0.2, speed: 0.05, viscous: 0.01 } opposing w;
        der(e) = w;
        der(w) = (F - 5.0 * e - kd * w - 10.0 * i) / 0.01;
        der(i) = e;
    }
}

model! {
    /// A wiper blade: an arm and a lip.
    struct Wiper {
        state arm: m = 0.0;
        state va: m/s = 0.0;
        state lip: m = 0.0;
        state vl: m/s = 0.0;
        param wipe: m/s = 0.3;
        friction F: N = Weakening { limit: 14.0, decay: 1.4 / 0.6 } opposing vl - wipe;
        der(arm) = va;
        der(va) = (-2000.0 * arm - va + 800.0 * (lip - arm) + 0.05 * (vl - va)) / 0.2;
        der(lip) = vl;
        der(vl) = (F - 800.0 * (lip - arm) - 0.05 * (vl - va)) / 0.01;
    }
}

model! {
    /// A tip on a driven beam, clamped with some play, that taps a sample (after Hertz 1881).
    struct Tapping {
        state x = 0.0;
        state v = 0.0;
        param force = 0.06;
        param omega = 0.9 where omega > 0.0;
        drive phi at omega;
        press N = Hertz { load: 2.0, depth: 0.1 } closing 1.0 - x;
        friction F = Coulomb { level: 0.005 } opposing v;
        der(x) = v;
        der(v) = force * cos(phi) - x - 0.04 * v - N + F;
    }
}

/// Its equations are singular there, and Newton's method would leave it.
#[test]
fn an_orbit_that_was_saved_at_a_fold_is_found_again() {
    let system = System::of::<Tapping, _>();
    let found = branch(&[], Tapping::omega, (0.7, 1.3), |_| {});
    let folds = found.special.iter().filter(|one| one.kind == Kind::Fold);
    let again = |fold: &Special| {
        let case = Case {
            start: Some(fold.state.clone()),
            modes: fold.modes.clone(),
            period: Some(fold.period),
            ..Case::declared(system.info(), Dynamics::Exact).with(Tapping::omega, fold.r)
        };
        let orbit = system.orbit(&case).expect("an orbit");
        assert!(
            (orbit.period * fold.r - TAU).abs() < 1e-9,
            "{}",
            orbit.period
        );
        // It touches the sample, as the fold does, and another orbit there need not.
        for (found, saved) in orbit.max_abs.iter().zip(&fold.max_abs).take(2) {
            assert!((found - saved).abs() < 1e-5 * saved, "{found} {saved}");
        }
    };
    assert!(folds.map(again).count() >= 2, "{:?}", named(&found));
}

/// r does not change at a fold, and the period does: its own error is told beside it.
#[test]
fn the_period_at_a_fold_is_right_within_its_own_error() {
    let folds = |range, accuracy| {
        let found = branch(&[], Sommerfeld::torque, range, |case| {
            case.accuracy = accuracy
        });
        assert_eq!(found.special.len(), 2, "{:?}", named(&found));
        let mut folds = found.special;
        folds.sort_by(|a, b| a.r.total_cmp(&b.r));
        folds
    };
    let known = folds((0.5, 1.5), 1e-11);
    for range in [(0.5, 1.5), (1.5, 0.5)] {
        for (fold, known) in folds(range, 1e-9).iter().zip(&known) {
            assert_eq!(fold.kind, Kind::Fold);
            let error = fold.period_error.expect("an error");
            let off = (fold.period - known.period).abs();
            assert!(
                off <= error + known.period_error.unwrap(),
                "{off:e} {error:e}"
            );
            assert!(error < 1e-6 * fold.period, "{error:e}");
            assert!((fold.r / known.r - 1.0).abs() < 1e-9);
        }
    }
}

/// It hunts ever more slowly towards kd = 1.72, as the inverse of the distance; there is no fold on the way.
#[test]
fn a_hunt_that_lasts_ever_longer_has_an_end() {
    let found = branch(&[], Servo::kd, (0.1, 2.0), |_| {});
    let Ending::Unbounded(kd) = found.ended.ending else {
        panic!("{} {:?}", found.ended.reason, named(&found));
    };
    // Weakening by 0.1/0.05 at no speed, less what is viscous: sliding slowly is damped by more beyond.
    assert!((kd - 1.72).abs() < 5e-3, "{kd}");
    assert!(found.special.len() <= 1, "{:?}", named(&found));
}

/// Where a slide is repelled by 1e15 once around, nothing is known of the other multiplier, and nothing is read from it.
#[test]
fn digits_of_a_multiplier_that_are_noise_are_no_bifurcations() {
    let found = branch(&[], Wiper::wipe, (0.3, 0.46), |_| {});
    let kinds: Vec<Kind> = found.special.iter().map(|one| one.kind).collect();
    let begin = [Kind::AddingSliding, Kind::Flip, Kind::Fold];
    assert!(kinds.starts_with(&begin), "{:?}", named(&found));
    let rest = &kinds[begin.len()..];
    assert!(
        rest.iter().all(|kind| *kind == Kind::Fold),
        "{:?}",
        named(&found)
    );
    let largest = |one: &OrbitRecord| one.floquet.multipliers[0].norm();
    let most = found.points.iter().map(largest).fold(0.0, f64::max);
    assert!(most > 1e13, "{most:e}");
}

/// A long step may lead from the first leg of an S to the last one: both are as unstable, and neither fold showed.
#[test]
fn no_step_leaps_over_an_s() {
    let given = [
        (BeltPair::alpha, 2.327_477_562_565_064),
        (BeltPair::beta, 2.776_959_233_866_162_6),
        (BeltPair::gamma, 1.338_983_798_756_980_4),
    ];
    let range = (0.113_770_007_722_753_46, 0.226_980_820_056_865_26);
    let found = branch(&given, BeltPair::v_dr, range, |case| {
        case.start = Some(vec![
            -0.273_688_043_1,
            0.0,
            0.156_525_373_8,
            -0.465_033_336_7,
        ]);
        case.period = Some(43.240_760);
    });
    let known = [
        ("VS1", 0.131_800_1),
        ("LP1", 0.166_977_634),
        ("PD1", 0.166_747_504),
        ("PD2", 0.133_564_948),
        ("LP2", 0.133_427_566_4),
        ("LP3", 0.143_015_131_9),
        ("PD3", 0.142_914_513_2),
    ];
    let told = named(&found);
    assert_eq!(told.len(), known.len(), "{told:?}");
    for ((name, r), (special, known)) in told.iter().zip(known) {
        assert!(*name == special && (r - known).abs() < 1e-7, "{told:?}");
    }
}

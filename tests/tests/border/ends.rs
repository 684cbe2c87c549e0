//! Where branches end, and that they say so at any accuracy.

use std::f64::consts::TAU;

use stickslip::continuation::{Ending, Kind};
use stickslip::model;
use stickslip::study::{OrbitRecord, Stability};
use stickslip_models::friction::{Coulomb, CoulombStatic, Stribeck};
use stickslip_models::{BeltPair, ForcedBelt};
use stickslip_tests::branches::{branch, named};

model! {
    /// Two masses on a belt, joined by a spring.
    struct Joined {
        state x[2]: m = 0.0;
        state v[2]: m/s = 0.0;
        param k: N/m = 100.0;
        param joint: N/m = 30.0;
        param c: N*s/m = 0.2;
        param belt: m/s = 0.1;
        param mass: kg = 1.0;
        for i in 0..2 {
            friction F[i]: N = Stribeck { static_level: 2.0, kinetic_level: 1.2, speed: 0.05, exponent: 2.0, viscous: 0.0 }
                opposing v[i] - belt;
            der(x[i]) = v[i];
        }
        der(v[0]) = (F[0] - k * x[0] - joint * (x[0] - x[1]) - c * v[0]) / mass;
        der(v[1]) = (F[1] - 1.3 * k * x[1] - joint * (x[1] - x[0]) - c * v[1]) / mass;
    }
}

model! {
    /// Prigogine and Lefever's reaction: its cycle shrinks onto x = A, y = B/A where B = 1 + A², there of the frequency A.
    struct Brusselator {
        state x = 1.0;
        state y = 1.0;
        param A = 1.0 where A > 0.0;
        param B = 3.0 where B > 0.0;
        der(x) = A + powi(x, 2) * y - (B + 1.0) * x;
        der(y) = B * x - powi(x, 2) * y;
    }
}

model! {
    /// A rotor on a stator that passes below it, always faster, and presses more in one half of each turn.
    struct Ultrasonic {
        state w: rad/s = 0.0;
        param torque: N*m = 0.15;
        drive phi at 2000.0;
        friction F: N = Coulomb { level: 0.2 * (50.0 + 40.0 * cos(phi)) } opposing 0.02 * w - 0.3 * cos(phi);
        der(w) = (0.02 * F - torque) / 1e-4;
    }
}

model! {
    /// A sledge that is pulled by a spring.
    struct Pulled {
        state stretch: m = 0.0;
        state v: m/s = 0.0;
        param pull: m/s = 0.1;
        friction F: N = CoulombStatic { static_level: 4.0, kinetic_level: 2.0 } opposing v;
        der(stretch) = pull - v;
        der(v) = (50.0 * stretch + F) / 2.0;
    }
}

/// Running ever backwards, friction is 0.02 · 0.2 · 50 in the mean at any speed: a load of as much leaves the speed open.
#[test]
fn a_family_at_one_value_of_the_parameter_is_an_end() {
    let found = branch(&[], Ultrasonic::torque, (0.15, 0.25), |_| {});
    let Ending::Family(torque) = found.ended.ending else {
        panic!("{}", found.ended.reason);
    };
    assert!((torque - 0.2).abs() < 1e-9, "{torque}");
    assert!(found.points.len() < 200 && found.ended.is_located());
    assert!(found.ended.reason.starts_with("at 0.2 it stands still"));
}

/// It sticks for (4 − 2 · 2 + 4) / (50 pull) s, which has no bound where nothing pulls any more.
#[test]
fn a_motion_that_comes_to_a_standstill_lasts_without_bound() {
    let found = branch(&[], Pulled::pull, (0.1, -0.1), |_| {});
    let Ending::Unbounded(pull) = found.ended.ending else {
        panic!("{} {:?}", found.ended.reason, named(&found));
    };
    assert!(pull.abs() < 1e-7, "{pull:e}");
    let last = found.points.last().expect("an orbit");
    let sticks = 4.0 / (50.0 * last.r.unwrap());
    assert!((last.period / sticks - 1.0).abs() < 1e-3 && last.period > 1e3);
}

#[test]
fn a_range_that_ends_before_the_standstill_is_followed_to_its_end() {
    let found = branch(&[], Pulled::pull, (0.1, 1e-6), |_| {});
    assert!(found.ended.reaches_bound(), "{}", found.ended.reason);
    let periods = [&found.points[0], found.points.last().expect("an orbit")].map(|one| one.period);
    assert!(periods[1] > 1e4 * periods[0], "{periods:?}");
}

/// As an orbit shrinks, 1 − μ falls with the square of its size, and is noise before the orbit is: what noise says is not
/// told, and no step fails on it.
#[test]
fn an_orbit_that_shrinks_onto_a_hopf_point_meets_nothing_else() {
    for accuracy in [1e-6, 1e-8, 1e-9, 1e-10, 1e-11] {
        for (a, from) in [(1.0, 3.0), (0.7, 2.0), (2.0, 7.0)] {
            let given = [(Brusselator::A, a)];
            let found = branch(&given, Brusselator::B, (from, 1.0), |case| {
                case.accuracy = accuracy;
            });
            let [hopf] = &found.special[..] else {
                panic!("{accuracy:e}: {:?} {}", named(&found), found.ended.reason);
            };
            assert!(matches!(found.ended.ending, Ending::At(Kind::Hopf, _)));
            assert!(
                (hopf.r - 1.0 - a * a).abs() < 1e-10,
                "{accuracy:e}: {}",
                hopf.r
            );
            assert!((hopf.period * a / TAU - 1.0).abs() < 1e-9, "{accuracy:e}");
            let stable = |one: &OrbitRecord| one.floquet.stability == Stability::Stable;
            assert!(found.points.iter().all(stable), "{accuracy:e}");
        }
    }
}

/// Both modes of vibration lose their damping at one speed, at which friction falls at the rate c. The branch of pure slip
/// shrinks onto the equilibrium there: it does not pass to the other side of its orbits, along which it would run back.
#[test]
fn a_branch_that_shrinks_onto_an_equilibrium_ends_there() {
    let found = branch(&[], Joined::belt, (0.1, 1.0), |_| {});
    let Ending::At(Kind::Hopf, r) = found.ended.ending else {
        panic!("{}", found.ended.reason);
    };
    let falls = |r: f64| {
        let speed = r / 0.05;
        2.0 * 0.8 * speed * (-speed * speed).exp() / 0.05
    };
    let last = found.special.last().expect("the Hopf point");
    let error = last.error.expect("an error");
    assert_eq!((last.label.as_str(), last.r), ("HB1", r));
    assert!(
        (falls(r - error) - 0.2) * (falls(r + error) - 0.2) < 0.0 && error < 1e-10,
        "{r} ± {error}"
    );
    // Without damping the stiffnesses alone tell how fast they vibrate.
    let [low, high] = [-1.0, 1.0].map(|side: f64| (145.0 + side * 1125_f64.sqrt()).sqrt());
    let turn = TAU / last.period;
    let nearest = if (turn - low).abs() < (turn - high).abs() {
        low
    } else {
        high
    };
    assert!((turn / nearest - 1.0).abs() < 1e-9, "{turn}");
}

/// Without damping, and where friction is weaker than the load, nothing bounds the motion at resonance: k = m ω².
#[test]
fn at_resonance_it_grows_without_bound() {
    let (m, omega) = (1.449_382_182_821_934_4, 0.668_520_719_750_025_9);
    let given = [
        (ForcedBelt::m, m),
        (ForcedBelt::omega, omega),
        (ForcedBelt::v_dr, 0.498_333_657_834_848_34),
        (ForcedBelt::load, 0.587_744_762_585_870_7),
        (ForcedBelt::F_s, 0.612_791_429_316_064_8),
        (ForcedBelt::delta, 0.412_923_187_979_681_86),
    ];
    let found = branch(
        &given,
        ForcedBelt::k,
        (1.192_502_977_641_778_6, 0.56),
        |_| {},
    );
    let Ending::Unbounded(k) = found.ended.ending else {
        panic!("{}", found.ended.reason);
    };
    assert!((k / (m * omega * omega) - 1.0).abs() < 1e-5, "{k}");
}

/// A doubled orbit meets the one that it doubles, also where its last points are that one as far as their digits tell.
#[test]
fn both_halves_become_one_at_any_accuracy() {
    let given = [
        (ForcedBelt::k, 0.443_508_737_309_091_1),
        (ForcedBelt::v_dr, 0.242_675_680_993_811_43),
        (ForcedBelt::load, 0.548_724_946_248_235_5),
        (ForcedBelt::omega, 1.085_845_608_745_264_8),
        (ForcedBelt::F_s, 0.569_328_085_382_962),
        (ForcedBelt::delta, 0.579_899_335_053_929_9),
    ];
    let met = [1e-7, 1e-9, 3.145_586e-11].map(|accuracy| {
        let range = (0.906_300_382_136_738_9, 1.916_832_319_774_343);
        let found = branch(&given, ForcedBelt::m, range, |case| {
            case.accuracy = accuracy
        });
        let Ending::Meets(Kind::Flip, m) = found.ended.ending else {
            panic!("{accuracy:e}: {}", found.ended.reason);
        };
        let last = found.special.last().expect("where they meet");
        (m, last.error.expect("an error"))
    });
    for (m, error) in met {
        assert!((m - met[2].0).abs() <= error + met[2].1, "{met:?}");
        assert!(error < 1e-5 * m, "{met:?}");
    }
}

/// Where the orbit of a drive is about to stick, one leaves it that goes around three times. Followed back, that ends there: it
/// neither becomes the shorter orbit three times over nor runs back along itself.
#[test]
fn an_orbit_that_triples_ends_where_its_laps_become_one() {
    let given = [
        (ForcedBelt::m, 1.015_592_596_388_482_2),
        (ForcedBelt::k, 0.616_387_115_457_787_7),
        (ForcedBelt::v_dr, 0.970_845_588_447_159_4),
        (ForcedBelt::omega, 1.120_440_021_709_005),
        (ForcedBelt::F_s, 0.567_908_628_087_658_7),
        (ForcedBelt::delta, 0.521_090_650_234_192_1),
    ];
    for accuracy in [1e-9, 3.9e-9] {
        let range = (0.434_679_490_763_142_6, 0.945_842_140_698_558_1);
        let found = branch(&given, ForcedBelt::load, range, |case| {
            case.accuracy = accuracy
        });
        let points = found.points.iter();
        let loads: Vec<f64> = points.filter_map(|point| point.r).collect();
        assert!(loads.is_sorted(), "{loads:?}");
        let last = found.points.last().expect("points");
        assert!((last.period * given[3].1 / TAU - 3.0).abs() < 1e-9);
        assert!((0.588_3..0.588_331).contains(&loads[loads.len() - 1]));
        let names: Vec<&str> = named(&found).iter().map(|one| one.0).collect();
        assert_eq!(names, ["SS1"]);
    }
}

/// "No orbit continues it" was said of the graze at the one accuracy, and not at the others.
#[test]
#[ignore = "long"]
fn a_branch_ends_in_one_place_at_any_accuracy() {
    let given = [
        (BeltPair::alpha, 1.069_784_002_804_739_8),
        (BeltPair::gamma, 3.442_412_413_550_149_7),
        (BeltPair::v_dr, 0.375_157_843_524_35),
    ];
    for accuracy in [1e-6, 1e-8, 1e-10] {
        let range = (2.281_562_119_987_861, 0.912_624_847_995_144_4);
        let found = branch(&given, BeltPair::beta, range, |case| {
            case.accuracy = accuracy
        });
        let names: Vec<&str> = named(&found).iter().map(|one| one.0).collect();
        assert_eq!(
            names,
            ["VS1", "CS1", "GS1", "CS2", "PD1", "PD2"],
            "{accuracy:e}"
        );
        assert!(matches!(found.ended.ending, Ending::Meets(Kind::Flip, _)));
    }
}

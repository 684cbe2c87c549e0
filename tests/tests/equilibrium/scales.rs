//! Equilibria whose states are of very different sizes, or have none: where no rate depends on them.

use stickslip::model;
use stickslip::study::{Beginning, Case, Dynamics, Kind, OrbitError, StudyError, System};
use stickslip_models::friction::Tustin;
use stickslip_tests::branches::branch;
use stickslip_tests::range::{place, range};

model! {
    /// A plate that a voltage pulls over a gap, in SI units: micrometres and picocoulombs.
    struct Plate {
        state x: m = 0.0;
        state v: m/s = 0.0;
        state q: A*s = 0.0;
        param volt: V = 5.0;
        param mass: kg = 1.0e-10 where mass > 0.0;
        param k: N/m = 5.0 where k > 0.0;
        param c: N*s/m = 2.0e-6;
        param gap: m = 2.0e-6 where gap > 0.0;
        param area: A*s*m/V = 8.854e-20 where area > 0.0;
        param resist: V/A = 2.0e8 where resist > 0.0;
        der(x) = v;
        der(v) = (powi(q, 2) / (2 * area) - k * x - c * v) / mass;
        der(q) = (volt - q * (gap - x) / area) / resist;
    }
}

model! {
    /// A block on rate-and-state friction, pulled by a spring whose end runs on: no rate depends on where that is.
    struct Block {
        state rate = 0.5;
        state age = 0.0;
        state end = 3.0;
        param k = 0.6 where k > 0.0;
        param a = 0.1;
        param b = 0.5;
        param eta = 0.1;
        let change = exp(-age) - exp(rate);
        der(age) = change;
        der(end) = 1.0 - exp(rate);
        der(rate) = (k * (1.0 - exp(rate)) - b * change) / (a + eta * exp(rate));
    }
}

model! {
    /// A braked wheel on its tyre, its light caliper on a stiff bracket: the wheel and the tyre hardly swing with it.
    struct BrakedWheel {
        state w = 40.0;
        state s = 0.0;
        state xc = 0.0;
        state vc = 0.0;
        param clamp = 400.0;
        friction T = Tustin { static_level: 1.3 * clamp, kinetic_level: clamp, speed: 2.0, viscous: 0.0 } opposing w - vc;
        let tyre = 3500.0 * tanh(4.0e5 * s / 3500.0);
        der(w) = T + 0.3 * tyre;
        der(s) = 15.0 - 0.3 * w - 150.0 * s;
        der(xc) = vc;
        der(vc) = (-T - 2.0e4 * xc - vc) / 0.05;
    }
}

const GAP: f64 = 2e-6;

#[test]
fn a_plate_of_micrometres_rests_where_its_cubic_says() {
    let system = System::of::<Plate, _>();
    let case = Case::declared(system.info(), Dynamics::Smooth);
    let found = system.equilibria(&case).unwrap();
    // k x (gap − x)² = area volt²/2: two inside of the gap, and one beyond.
    assert_eq!(found.len(), 3, "{found:?}");
    for one in &found {
        let [x, _, q] = one.state[..] else {
            panic!("three states")
        };
        let pull = 8.854e-20 * 25.0 / 2.0;
        let off = 5.0 * x * (GAP - x).powi(2) / pull - 1.0;
        assert!(off.abs() < 1e-9, "{x:e}: {off:e}");
        assert!(
            (q * (GAP - x) / 8.854e-20 / 5.0 - 1.0).abs() < 1e-9,
            "{q:e}"
        );
    }
}

#[test]
fn a_plate_is_pulled_in_at_a_third_of_its_gap() {
    let system = System::of::<Plate, _>();
    let right = (8.0 * 5.0 * GAP.powi(3) / (27.0 * 8.854e-20)).sqrt();
    for from in [0.0, 5.0] {
        let mut case = Case::declared(system.info(), Dynamics::Smooth);
        case.along = Some(range(&system, "volt", from, 20.0));
        let found = system.equilibria_along(&case.at(from)).unwrap();
        let [fold] = &found.special[..] else {
            panic!("{from}: {:?}", found.special)
        };
        assert_eq!(fold.kind, Kind::Fold);
        assert!((fold.r / right - 1.0).abs() < 1e-10, "{} {right}", fold.r);
    }
}

#[test]
fn an_end_that_runs_on_is_kept_anywhere() {
    // With A = a + eta and k = b − A the trace vanishes, and ω² = k/A.
    let system = System::of::<Block, _>();
    let mut case = Case::declared(system.info(), Dynamics::Smooth);
    let found = system.equilibria(&case).unwrap();
    let [one] = &found[..] else {
        panic!("{found:?}")
    };
    assert_eq!((one.eigenvalues.len(), one.state[2]), (2, 3.0));
    case.along = Some(range(&system, "k", 0.6, 0.1));
    let along = system.equilibria_along(&case.at(0.6)).unwrap();
    let [hopf] = &along.special[..] else {
        panic!("{:?}", along.special)
    };
    assert_eq!(hopf.kind, Kind::Hopf);
    assert!((hopf.r - 0.3).abs() < 1e-10, "{}", hopf.r);
    let period = std::f64::consts::TAU / 1.5_f64.sqrt();
    assert!((hopf.period.unwrap() / period - 1.0).abs() < 1e-9);
}

#[test]
fn orbits_begin_where_only_a_light_part_swings() {
    let found = branch::<BrakedWheel, _>(&[], BrakedWheel::clamp, (900.0, 1100.0), |case| {
        case.beginning = Beginning::Hopf
    });
    let first = &found.points[0];
    // By the Jacobian's eigenvalues, and by shooting with another integrator, which closes to 1e-13.
    assert!((first.r.unwrap() - 1047.99997).abs() < 0.5, "{:?}", first.r);
    assert!((first.period - 9.9348e-3).abs() < 5e-6, "{}", first.period);
    assert!(found.points.len() > 5, "{:?}", found.ended);
}

#[test]
fn what_rings_by_its_errors_alone_has_come_to_rest() {
    let system = System::of::<BrakedWheel, _>();
    let mut case = Case::declared(system.info(), Dynamics::Exact);
    case.parameters[place(&system, "clamp")] = 100.0;
    let error = system.orbit(&case).unwrap_err();
    let StudyError::Orbit(OrbitError::Equilibrium { state }) = error else {
        panic!("{error}")
    };
    let state = format!("{state:?}");
    assert!(state.contains("49.582066"), "{state}");
}

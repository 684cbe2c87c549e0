//! Harmonically forced models: closed forms, an independent event-driven integration, and every command.

use std::f64::consts::{PI, TAU};

use stickslip::field::{Kernel, Smoothing};
use stickslip::study::trade::Scope;
use stickslip::study::{Case, Dynamics, OrbitRecord, StudyError, System};
use stickslip_models::systems;
use stickslip_tests::range::{place, range};

use crate::oscillators::{DenHartog, Forced};

fn case(model: &System, dynamics: Dynamics, set: &[(&str, f64)]) -> Case {
    let info = model.info();
    let mut case = Case::declared(info, dynamics);
    for (name, value) in set {
        case.parameters[place(model, name)] = *value;
    }
    case
}

#[track_caller]
fn close(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!(
        (found - expected).abs() <= tolerance,
        "{what}: {found} instead of {expected}"
    );
}

/// Amplitude, phase and multipliers of the damped oscillator.
fn check_response(orbit: &OrbitRecord, omega: f64, zeta: f64) {
    let period = TAU / omega;
    close(orbit.period, period, 1e-12 * period, "period");
    assert_eq!(orbit.period_count, 1);
    let (real, imaginary) = (1.0 - omega * omega, 2.0 * zeta * omega);
    let amplitude = 2.0 / real.hypot(imaginary);
    let lag = imaginary.atan2(real);
    close(orbit.max[0], amplitude, 1e-8 * amplitude, "largest");
    close(orbit.min[0], -amplitude, 1e-8 * amplitude, "smallest");
    close(orbit.state[2], 0.0, 1e-12, "phase at the start");
    close(
        orbit.state[0],
        amplitude * lag.cos(),
        1e-8 * amplitude,
        "x at phase 0",
    );
    close(
        orbit.state[1],
        omega * amplitude * lag.sin(),
        1e-8 * amplitude,
        "v at phase 0",
    );
    let multipliers = &orbit.floquet.multipliers;
    assert_eq!(multipliers.len(), 2, "{multipliers:?}");
    for multiplier in multipliers {
        close(multiplier.norm(), (-zeta * period).exp(), 1e-8, "modulus");
    }
}

#[test]
fn the_linear_response_is_the_closed_form() {
    let model = System::of::<Forced, _>();
    for (omega, zeta) in [(1.3, 0.1), (0.4, 0.02), (0.99, 0.2), (7.0, 0.05)] {
        let set = [("omega", omega), ("zeta", zeta)];
        let orbit = model.orbit(&case(&model, Dynamics::Smooth, &set));
        check_response(&orbit.expect("the response"), omega, zeta);
    }
}

#[test]
fn the_response_is_followed_through_resonance() {
    let model = System::of::<Forced, _>();
    let case = Case {
        along: Some(range(&model, "omega", 0.5, 2.0)),
        ..case(&model, Dynamics::Smooth, &[("omega", 0.5)])
    };
    let branch = model.branch(&case).expect("a branch");
    assert_eq!(branch.ended.word(), "reached-end");
    assert!(branch.points.len() > 5);
    for point in &branch.points {
        check_response(point, point.r.expect("a followed parameter"), 0.1);
    }
}

#[test]
fn a_driven_model_has_no_equilibrium() {
    let model = System::of::<Forced, _>();
    let error = model.equilibria(&case(&model, Dynamics::Smooth, &[]));
    assert!(
        matches!(error, Err(StudyError::Driven { phase: "phi", .. })),
        "{error:?}"
    );
    let standing = model.orbit(&case(&model, Dynamics::Smooth, &[("omega", 0.0)]));
    let message = standing.expect_err("a drive that stands still").to_string();
    assert_eq!(
        message,
        "the drive `phi` advances at the rate 0, which must be a finite number above 0"
    );
}

/// Den Hartog 1931: x_m = √(V² − F² U²) with V = 1/(1 − β²) and U = sin(π/β)/(β (1 + cos(π/β))), in units of P/k.
#[test]
fn dry_friction_damps_as_den_hartog_says() {
    let model = System::of::<DenHartog, _>();
    for (beta, level) in [(0.6, 0.2), (0.8, 0.5), (1.4, 0.3), (2.0, 0.1)] {
        let set = [("beta", beta), ("level", level)];
        let orbit = model
            .orbit(&case(&model, Dynamics::Exact, &set))
            .expect("the response");
        let turned = PI / beta;
        let damping = turned.sin() / (beta * (1.0 + turned.cos()));
        let response: f64 = 1.0 / (1.0 - beta * beta);
        let amplitude = (response * response - (level * damping).powi(2)).sqrt();
        let what = format!("at β = {beta}, {:?}", orbit.word);
        close(orbit.period, TAU / beta, 1e-11, &what);
        close(orbit.max[0], amplitude, 1e-9, &what);
        close(orbit.min[0], -amplitude, 1e-9, &what);
        assert_eq!(orbit.word.as_deref(), Some("slip-(F) slip+(F)"));
        assert_eq!(orbit.period_count, 1);
    }
}

/// Digits by event-driven integration of the three modes, at 3e-14, after eighty periods.
#[test]
fn stick_slip_under_a_force_agrees_with_an_independent_integration() {
    let model = systems::forced_belt();
    let orbit = model
        .orbit(&case(&model, Dynamics::Exact, &[]))
        .expect("stick-slip");
    close(orbit.period, TAU / 0.6, 1e-12, "period");
    close(orbit.state[0], 0.638_741_028_542_3, 1e-10, "x at phase 0");
    close(orbit.state[1], 0.5, 1e-12, "v at phase 0");
    assert_eq!(orbit.word.as_deref(), Some("stick(F) slip-(F) slip+(F)"));
    assert_eq!(orbit.floquet.multipliers.len(), 2);
    assert_eq!(
        orbit.floquet.log_moduli[1], None,
        "one contact sticks: an exact zero"
    );

    let set = [("load", 0.4), ("omega", 0.5), ("delta", 3.0)];
    let doubled = model
        .orbit(&case(&model, Dynamics::Exact, &set))
        .expect("stick-slip");
    close(
        doubled.period,
        2.0 * TAU / 0.5,
        1e-11,
        "two turns of the drive",
    );
    assert_eq!(doubled.period_count, 2);
    let strobes = [
        (1.665_441_136_519, 0.344_503_930_94),
        (0.110_633_744_667, 0.5),
    ];
    let near = |(x, v): &(f64, f64)| {
        (doubled.state[0] - x).abs() < 1e-9 && (doubled.state[1] - v).abs() < 1e-9
    };
    assert!(strobes.iter().any(near), "{:?}", doubled.state);
}

/// The smoothed copies tend to the exact orbit, the error of tanh falling with 1/ε.
#[test]
fn smooth_copies_of_a_forced_orbit_tend_to_it() {
    let model = systems::forced_belt();
    let exact = model
        .orbit(&case(&model, Dynamics::Exact, &[]))
        .expect("stick-slip");
    let error = |size: f64| {
        let smoothing = Smoothing {
            kernel: Kernel::Tanh,
            size,
        };
        let copy = case(&model, Dynamics::Smoothed(smoothing), &[]);
        let orbit = model.orbit(&copy).expect("the copy");
        close(orbit.period, exact.period, 1e-9, "period");
        (orbit.max[0] - exact.max[0]).abs()
    };
    let (coarse, fine) = (error(1e4), error(1e5));
    assert!(fine < 1e-3, "{fine:e}");
    let ratio = coarse / fine;
    assert!((7.0..12.5).contains(&ratio), "{coarse:e} {fine:e}");
}

#[test]
fn a_motion_and_a_branch_of_a_forced_contact() {
    let model = systems::forced_belt();
    let motion = model.motion(&case(&model, Dynamics::Exact, &[]), 30.0);
    assert!(motion.is_ok(), "{motion:?}");
    let case = Case {
        along: Some(range(&model, "omega", 0.6, 0.66)),
        ..case(&model, Dynamics::Exact, &[("omega", 0.6)])
    };
    let branch = model.branch(&case).expect("a branch");
    assert_eq!(branch.ended.word(), "reached-end");
    for point in &branch.points {
        let omega = point.r.expect("a followed parameter");
        close(point.period, TAU / omega, 1e-9, "period");
    }
}

#[test]
fn trade_measures_the_copies_of_a_forced_orbit() {
    let model = systems::forced_belt();
    let scope = Scope {
        kernels: vec![Kernel::Tanh],
        sign_sizes: vec![1e3, 1e4, 1e5],
        tolerances: Vec::new(),
        ..Scope::default()
    };
    let trade = model.trade(&case(&model, Dynamics::Exact, &[]), &scope);
    let trade = trade.expect("a trade");
    let curve = &trade.ends[0].trade.curves[0];
    assert_eq!(curve.points.len(), 3, "{:?}", curve.lost);
    for point in &curve.points {
        close(point.frequency, 0.0, 1e-12, "error of the frequency");
    }
    let last = &curve.points[2];
    assert!(last.max_abs[0].abs() < 1e-4, "{:?}", last.max_abs);
    let fit = curve.max_abs[0].expect("a fit");
    assert!((-1.2..-0.8).contains(&fit.a), "{fit:?}");
}

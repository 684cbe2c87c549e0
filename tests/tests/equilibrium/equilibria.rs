//! Equilibria.

use std::ops::ControlFlow;

use nalgebra::Complex;
use stickslip::bifurcation::Stability;
use stickslip::continuation::{Ending, Kind, Walked};
use stickslip::equilibrium::{EquilibriumPoint, find, follow, settings, starts, sticking_sets};
use stickslip::field::Design;
use stickslip::field::exact::Mode;
use stickslip::flow::{ExactFamily, FlowError, SmoothFamily};
use stickslip::integrate::Tolerance;
use stickslip::model;
use stickslip::model::{Model, ParamId};
use stickslip::motion::{Family, Place};
use stickslip::study::{Along, Case, Dynamics, StudyError, System};
use stickslip_models::friction::Coulomb;
use stickslip_models::{BeltOscillator, BeltPair, DrillString};

model! {
    /// The Brusselator: one equilibrium, x = a, y = b/a; Hopf at b = 1 + a² with frequency a.
    struct Brusselator {
        state x = 1.0;
        state y = 1.0;
        param a = 1.0 where a > 0.0;
        param b = 1.0;
        der(x) = a - (b + 1) * x + powi(x, 2) * y;
        der(y) = b * x - powi(x, 2) * y;
    }
}

model! {
    /// A mass that is held by a spring and by the ground.
    struct Held {
        state x = 1.0;
        state v = 0.0;
        param k = 1.0;
        friction F = Coulomb { level: 0.1 } opposing v;
        der(x) = v;
        der(v) = F - k * x;
    }
}

model! {
    /// Three states: r = x² − x³/3 with folds at x = 0 (r = 0) and x = 2 (r = 4/3), and a damped oscillator beside.
    struct Folds {
        state x = 3.1;
        state y = 0.0;
        state v = 0.0;
        param r = 0.0;
        der(x) = r - powi(x, 2) + powi(x, 3) / 3;
        der(y) = v;
        der(v) = -y - 0.3 * v + x;
    }
}

model! {
    /// A saddle whose eigenvalues, 1 and −1 − p, add up to zero at p = 0, and no Hopf point.
    struct NeutralSaddle {
        state x = 0.0;
        state y = 0.0;
        param p = 1.0;
        der(x) = x;
        der(y) = -(1 + p) * y;
    }
}

model! {
    /// A pitchfork at r = 0.
    struct Pitchfork {
        state x = 0.0;
        param r = 0.0;
        der(x) = r * x - powi(x, 3);
    }
}

fn smooth<M: Model<N>, const N: usize>(
    model: M,
    smoothing: Option<&str>,
    design: Design,
) -> SmoothFamily<M, N> {
    SmoothFamily {
        model,
        smoothing: smoothing.map(|text| text.parse().expect("a smoothing")),
        design,
        tolerance: Tolerance::for_accuracy(1e-9),
        magnitude: [1.0; N],
    }
}

fn declared<M: Model<N>, const N: usize>() -> [f64; N] {
    std::array::from_fn(|j| M::INFO.states[j].start)
}

/// The branch from the declared start without friction, or in a copy.
fn branch<M: Model<N>, const N: usize>(
    model: M,
    smoothing: Option<&str>,
    along: ParamId<M>,
    (from, to): (f64, f64),
) -> Walked<EquilibriumPoint, FlowError> {
    let family = Family::from(smooth(model, smoothing, Design::Parameter(along.index)));
    let found = find(&family, from, &starts(&declared::<M, N>()), |_| {
        vec![vec![]]
    });
    let first = found.first().expect("an equilibrium");
    follow(&family, &first.place, settings(from, to), &mut |_| {
        ControlFlow::Continue(())
    })
    .expect("a branch")
    .0
}

fn only(branch: &Walked<EquilibriumPoint, FlowError>, kind: Kind) -> (f64, f64) {
    let found: Vec<_> = branch.located.iter().map(|found| found.kind).collect();
    assert_eq!(found, [kind]);
    let spot = &branch.located[0].point;
    let frequency = spot.frequency().unwrap_or(0.0);
    (spot.r, frequency)
}

fn close(value: f64, expected: f64, tolerance: f64) {
    let error = (value - expected).abs() / expected.abs();
    assert!(error <= tolerance, "{value} against {expected}: {error:e}");
}

#[test]
fn the_brusselator_oscillates_from_one_plus_a_squared() {
    for a in [0.5, 1.0, 2.0, 3.7] {
        let model = Brusselator { a, b: 0.5 };
        let branch = branch(model, None, Brusselator::b, (0.5, 20.0));
        let (r, frequency) = only(&branch, Kind::Hopf);
        close(r, 1.0 + a * a, 1e-11);
        close(frequency, a, 1e-9);
        let last = branch.points.last().expect("a last point");
        assert_eq!(
            (last.r, last.spectrum.stability),
            (20.0, Stability::Unstable)
        );
        close(last.state[1], 20.0 / a, 1e-11);
    }
}

#[test]
fn folds_are_located_and_passed() {
    let branch = branch(Folds { r: -0.1 }, None, Folds::r, (-0.1, 2.0));
    let spots: Vec<_> = branch.located.iter().map(|found| &found.point).collect();
    assert!(branch.located.iter().all(|found| found.kind == Kind::Fold));
    let [upper, lower] = spots.as_slice() else {
        panic!("{} folds", spots.len());
    };
    close(upper.r, 4.0 / 3.0, 1e-11);
    assert!(lower.r.abs() < 1e-11, "{}", lower.r);
    assert!((upper.state[0] - 2.0).abs() < 1e-6 && lower.state[0].abs() < 1e-6);
}

#[test]
fn a_neutral_saddle_is_no_hopf_point() {
    let branch = branch(
        NeutralSaddle { p: 1.0 },
        None,
        NeutralSaddle::p,
        (1.0, -0.5),
    );
    assert!(branch.located.is_empty(), "{:?}", branch.located);
    assert!(branch.points.iter().all(|spot| spot.spectrum.unstable == 1));
}

#[test]
fn a_branch_point_is_no_fold() {
    let branch = branch(Pitchfork { r: -1.0 }, None, Pitchfork::r, (-1.0, 0.7));
    let (r, _) = only(&branch, Kind::BranchPoint);
    assert!(r.abs() < 1e-10, "{r}");
}

/// Theory 2.4: where the copy of the belt oscillator stops oscillating, for δ = 3.
#[test]
fn arctan_has_its_hopf_point_where_it_should() {
    let table = [
        ("arctan:1e2", 0.051_871_324_363_966),
        ("arctan:1e3", 0.015_184_465_035_846),
        ("arctan:1e4", 0.004_669_614_952_050_0),
        ("arctan:1e5", 0.001_463_077_125_274_3),
        ("arctan:1e6", 0.000_461_294_841_227_25),
        ("arctan:1e7", 0.000_145_736_765_653_51),
    ];
    for (smoothing, expected) in table {
        let model = BeltOscillator::default();
        let branch = branch(model, Some(smoothing), BeltOscillator::v_dr, (0.2, 1e-4));
        let (r, frequency) = only(&branch, Kind::Hopf);
        close(r, expected, 1e-10);
        close(frequency, 1.0, 1e-9);
    }
}

/// Thesis (3.9).
#[test]
fn the_copy_of_the_belt_oscillator_rests_where_the_thesis_says() {
    let model = BeltOscillator::default();
    let family = branch(model, Some("arctan:1e3"), BeltOscillator::v_dr, (0.4, 0.05));
    for spot in &family.points {
        let x = std::f64::consts::FRAC_2_PI * (1e3 * spot.r).atan() / (1.0 + 3.0 * spot.r);
        close(spot.state[0], x, 1e-12);
    }
}

/// Thesis (4.13): ψ is the bump of the friction at the speed of the table.
#[test]
fn the_copy_of_the_drill_string_rests_where_the_thesis_says() {
    let model = DrillString::default();
    let branch = branch(model, Some("quartic:1"), DrillString::eta, (3.9, 0.5));
    for spot in &branch.points {
        let (eta, q) = (spot.r, spot.r - 4.0);
        let psi = 4.2 / 27.0 * eta * (-q).powi(3);
        assert!(
            (spot.state[0] - psi).abs() < 1e-12 * (1.0 + psi),
            "{spot:?}"
        );
    }
    let hopf: Vec<f64> = branch.located.iter().map(|found| found.r).collect();
    close(hopf[0], 3.758_631_613_778_235, 1e-12);
    close(hopf[1], 1.018_074_273_032_957, 1e-12);
    assert_eq!(hopf.len(), 2);
}

model! {
    /// A motor that turns a load through a clutch.
    struct Clutched {
        state motor: rad/s = 90.0;
        state load: rad/s = 80.0;
        param J: kg*m^2 = 1.0 where J > 0.0;
        param speed: rad/s = 100.0;
        param gain: N*m*s = 3.0;
        param drag: N*m*s = 1.2;
        param cap: N*m = 100.0 where cap >= 0.0;
        friction T: N*m = Coulomb { level: cap } opposing load - motor;
        der(motor) = (gain * (speed - motor) - T) / J;
        der(load) = (T - drag * load) / J;
    }
}

#[test]
fn what_a_contact_holds_alone_is_followed_until_it_slips() {
    let system = System::of::<Clutched, _>();
    let along = Along {
        design: Design::Parameter(Clutched::cap.index),
        from: 100.0,
        to: 50.0,
    };
    let case = Case {
        along: Some(along),
        ..Case::declared(system.info(), Dynamics::Exact).at(100.0)
    };
    let branch = system.equilibria_along(&case).unwrap();
    // Both turn alike at w = gain · speed/(gain + drag), and the clutch bears what drags there.
    let together = 3.0 * 100.0 / 4.2;
    for point in &branch.points {
        assert_eq!(point.mode.as_deref(), Some("stick(T)"));
        close(point.state[0], together, 1e-11);
        close(point.state[1], together, 1e-11);
        // Two inertias of one under drag and gain.
        assert_eq!(point.eigenvalues.len(), 1);
        close(point.eigenvalues[0].re, -2.1, 1e-12);
    }
    let [end] = branch.special.as_slice() else {
        panic!("{:?}", branch.special);
    };
    assert_eq!(end.kind, Kind::BoundaryEquilibrium);
    close(end.r, 1.2 * together, 1e-10);
    assert!(branch.ended.reason.contains("the force that holds `T`"));
}

model! {
    /// A mass in two wells, at 1 and at -1, with a top between them.
    struct Wells {
        state x = 0.9;
        state v = 0.0;
        param tilt = 0.0;
        der(x) = v;
        der(v) = x - powi(x, 3) - 0.1 * v + tilt;
    }
}

#[test]
fn what_a_branch_does_not_pass_is_told() {
    let system = System::of::<Wells, _>();
    let along = Along {
        design: Design::Parameter(Wells::tilt.index),
        from: 0.0,
        to: 0.1,
    };
    let case = Case {
        along: Some(along),
        ..Case::declared(system.info(), Dynamics::Smooth)
    };
    let branch = system.equilibria_along(&case).unwrap();
    let first = branch.points[0].state[0];
    let mut all: Vec<f64> = branch.others.iter().map(|one| one.state[0]).collect();
    all.push(first);
    all.sort_by(f64::total_cmp);
    assert_eq!(all.len(), 3);
    for (found, right) in all.into_iter().zip([-1.0, 0.0, 1.0]) {
        assert!((found - right).abs() < 1e-9, "{found} for {right}");
    }
}

fn exact<M: Model<N>, const N: usize>(model: M, along: ParamId<M>) -> ExactFamily<M, N> {
    ExactFamily {
        model,
        design: Some(along.index),
        tolerance: Tolerance::for_accuracy(1e-9),
        magnitude: [1.0; N],
    }
}

#[test]
fn the_exact_belt_oscillator_slides_unstably_until_its_boundary() {
    let family: Family = exact(BeltOscillator::default(), BeltOscillator::v_dr).into();
    let modes = vec![Mode::SlideBackward];
    let start = Place {
        state: vec![0.6, 0.0],
        modes,
    };
    let (branch, _) = follow(&family, &start, settings(0.2, -0.1), &mut |_| {
        ControlFlow::Continue(())
    })
    .expect("a branch");
    assert!(matches!(
        branch.ending,
        Ending::At(Kind::BoundaryEquilibrium, _)
    ));
    let last = branch.points.last().expect("a last point");
    assert_eq!(last.margin().map(|(contact, _)| contact), Some(0));
    let (r, _) = only(&branch, Kind::BoundaryEquilibrium);
    assert!(r.abs() < 1e-15, "{r}");
    for spot in &branch.points {
        close(spot.state[0], 1.0 / (1.0 + 3.0 * spot.r), 1e-12);
        assert_eq!(spot.spectrum.stability, Stability::Unstable);
    }
}

#[test]
fn the_exact_drill_string_slides_stably() {
    let family: Family = exact(DrillString::default(), DrillString::eta).into();
    let modes = vec![Mode::SlideForward];
    let start = Place {
        state: vec![1.0, 0.0],
        modes,
    };
    let (branch, _) = follow(&family, &start, settings(6.0, 0.01), &mut |_| {
        ControlFlow::Continue(())
    })
    .expect("a branch");
    assert!(branch.located.is_empty());
    let expected = Complex::new(-0.05, (1.0_f64 - 0.05 * 0.05).sqrt());
    for spot in &branch.points {
        assert!(spot.state[0].abs() < 1e-12);
        assert!((spot.spectrum.eigenvalues[0] - expected).norm() < 1e-12);
    }
}

#[test]
fn a_mass_sticks_wherever_friction_holds_its_spring() {
    let model = BeltOscillator {
        v_dr: 0.0,
        k: 4.0,
        ..Default::default()
    };
    let stick = [vec![Mode::Stick]];
    let sets = sticking_sets(
        &*Family::from(exact(model, BeltOscillator::v_dr))
            .at(0.0)
            .unwrap(),
        &[vec![1.0, 0.3]],
        &stick,
    );
    let [set] = sets.as_slice() else {
        panic!("{} sets", sets.len());
    };
    assert_eq!(set.dimension, 1);
    close(set.low[0], -0.25, 1e-12);
    close(set.high[0], 0.25, 1e-12);
    assert_eq!(set.spectrum.stability, Stability::Stable);
    // A moving belt lets nothing rest.
    let moving = sticking_sets(
        &*Family::from(exact(BeltOscillator::default(), BeltOscillator::v_dr))
            .at(0.2)
            .unwrap(),
        &[vec![1.0, 0.3]],
        &stick,
    );
    assert!(moving.is_empty());
}

/// Both springs pull with (1 + α)x₁ − αx₂ ≤ 1 and (1 + α)x₂ − αx₁ ≤ β at their corner.
#[test]
fn two_masses_stick_in_a_parallelogram() {
    let model = BeltPair {
        v_dr: 0.0,
        ..Default::default()
    };
    let stick = [vec![Mode::Stick; 2]];
    let sets = sticking_sets(
        &*Family::from(exact(model, BeltPair::v_dr)).at(0.0).unwrap(),
        &[vec![0.1, 0.2, 0.0, 0.1]],
        &stick,
    );
    let [set] = sets.as_slice() else {
        panic!("{} sets", sets.len());
    };
    assert_eq!(set.dimension, 2);
    let (alpha, beta) = (1.2, 1.3);
    let determinant = (1.0 + alpha) * (1.0 + alpha) - alpha * alpha;
    close(
        set.high[0],
        ((1.0 + alpha) + alpha * beta) / determinant,
        1e-12,
    );
    close(
        set.low[2],
        -((1.0 + alpha) * beta + alpha) / determinant,
        1e-12,
    );
}

#[test]
fn proof() {
    use stickslip::equilibrium::prove;
    use stickslip::field::EnclosedField;
    let slip = 1.0 / (1.0 + 3.0 * 0.2);
    for (smoothing, share) in [
        ("tanh:10", (0.2 * 10_f64).tanh()),
        ("cubic:1e5", 1.0),
        ("quintic:5", 1.0),
    ] {
        let field =
            EnclosedField::smooth(&BeltOscillator::default(), Some(smoothing.parse().unwrap()));
        let p = prove(&field, &[slip * share, 0.0]).unwrap();
        assert!(
            p.low[0] <= slip * share + 1e-15
                && slip * share <= p.high[0] + 1e-15
                && p.high[0] - p.low[0] < 1e-12,
            "{p:?}"
        );
        assert!(prove(&field, &[slip * share]).is_err());
    }
}

/// Where friction holds whatever rests, there are sets of equilibria and none to follow: their modes are told.
#[test]
fn only_sets_of_rest() {
    let system = System::of::<Held, 2>();
    let mut case = Case::declared(system.info(), Dynamics::Exact);
    let design = Design::Parameter(Held::k.index);
    let (from, to) = (1.0, 2.0);
    case.along = Some(Along { design, from, to });
    let refused = system.equilibria_along(&case).expect_err("a set");
    let StudyError::OnlySets { modes } = refused else {
        panic!("{refused}");
    };
    assert_eq!(modes, "stick(F)");
}

//! Frequency responses: amplitude and phase against closed forms and against what the equations demand of them.

use std::f64::consts::TAU;

use nalgebra::Complex;
use stickslip::field::Design;
use stickslip::flow::SmoothFamily;
use stickslip::harmonics::{Around, Harmonic, harmonics};
use stickslip::integrate::Tolerance;
use stickslip::model;
use stickslip::motion::Family;
use stickslip::study::{Case, Dynamics, OrbitRecord, System};
use stickslip_models::friction::Jenkins;
use stickslip_tests::range::{place, range};

use crate::oscillators::{DenHartog, Forced};

model! {
    /// A turbine blade of two masses with an underplatform damper at the inner one.
    struct Blade {
        state x1: m = 0.0;
        state x2: m = 0.0;
        state v1: m/s = 0.0;
        state v2: m/s = 0.0;
        state z: N = 0.0;
        param m1: kg = 1.0 where m1 > 0.0;
        param m2: kg = 1.0 where m2 > 0.0;
        param k1: N/m = 1.0 where k1 > 0.0;
        param k2: N/m = 1.0 where k2 > 0.0;
        param c: N*s/m = 0.02 where c >= 0.0;
        param kd: N/m = 0.5 where kd > 0.0;
        param level: N = 0.2 where level > 0.0;
        param load: N = 0.1;
        param omega: rad/s = 0.4 where omega > 0.0;
        drive phi at omega;
        friction F: N = Jenkins { stiffness: kd, level: level } opposing v1 with z;
        der(x1) = v1;
        der(x2) = v2;
        der(v1) = (F - k1 * x1 - c * v1 - k2 * (x1 - x2) - c * (v1 - v2)) / m1;
        der(v2) = (-k2 * (x2 - x1) - c * (v2 - v1) + load * cos(phi)) / m2;
    }
}

fn complex(harmonic: &Harmonic, state: usize) -> Complex<f64> {
    Complex::from_polar(harmonic.amplitude[state], harmonic.phase[state])
}

fn known(orbit: &OrbitRecord) -> &[Harmonic] {
    orbit.harmonics.as_ref().expect("harmonics")
}

#[track_caller]
fn close(found: Complex<f64>, expected: Complex<f64>, tolerance: f64, what: &str) {
    let off = (found - expected).norm();
    assert!(
        off <= tolerance,
        "{what}: {found} instead of {expected}, off by {off:e}"
    );
}

/// Through a resonance of Q = 25, amplitude and phase to nine digits; nothing at the third harmonic.
#[test]
fn a_linear_response_is_its_closed_form_through_resonance() {
    let model = System::of::<Forced, _>();
    let mut case = Case::declared(model.info(), Dynamics::Smooth);
    case.parameters[place(&model, "zeta")] = 0.02;
    case.along = Some(range(&model, "omega", 0.5, 2.0));
    case.harmonics = vec![1, 3];
    let case = case.at(0.5);
    let branch = model.branch(&case);
    let branch = branch.expect("a branch");
    assert_eq!(branch.ended.word(), "reached-end");
    for point in &branch.points {
        let omega = point.r.expect("a followed parameter");
        let expected = 2.0 / Complex::new(1.0 - omega * omega, 0.04 * omega);
        let size = expected.norm();
        let what = format!("at {omega}");
        let [first, third] = known(point) else {
            panic!("two harmonics")
        };
        close(complex(first, 0), expected, 1e-9 * size, &what);
        close(
            complex(first, 1),
            Complex::i() * omega * expected,
            1e-9 * size * omega,
            &what,
        );
        assert!(third.amplitude[0] <= 1e-9 * size, "{what}: {third:?}");
        for harmonic in [first, third] {
            assert!(harmonic.error[0] < 1e-7 * size, "{what}: {harmonic:?}");
        }
    }
}

/// A sliding friction of constant size that turns twice in a period is a square wave.
#[test]
fn dry_friction_enters_each_harmonic_as_a_square_wave() {
    let model = System::of::<DenHartog, _>();
    for (beta, level) in [(0.6, 0.2), (0.8, 0.5), (1.4, 0.3)] {
        let mut case = Case::declared(model.info(), Dynamics::Exact);
        case.parameters = vec![beta, level];
        case.harmonics = vec![1, 2, 3, 5, 7];
        let orbit = model.orbit(&case).expect("the response");
        for harmonic in known(&orbit) {
            let h = harmonic.order as f64;
            let stiffness = Complex::from(1.0 - (h * beta).powi(2));
            let load = if harmonic.order == 1 { 1.0 } else { 0.0 };
            let friction = stiffness * complex(harmonic, 0) - load;
            // A square wave of period 2π: 4 level/(π h) at odd harmonics, nothing at even ones.
            let odd = harmonic.order % 2;
            let expected = odd as f64 * 4.0 * level / (std::f64::consts::PI * h);
            let tolerance = 1e-9 * (1.0 + (h * beta).powi(2));
            let off = (friction.norm() - expected).abs();
            assert!(off < tolerance, "{beta} {level} h = {h}: {off:e}");
        }
    }
}

/// By how much a series that ends with a harmonic misses the response at worst, or its rate: of what is left each harmonic
/// is that of the square wave, over the dynamic stiffness.
fn miss(last: usize, [beta, level]: [f64; 2], rate: bool) -> f64 {
    let left = |angle: f64| -> f64 {
        let orders = (last + 1..if rate { 100_000 } else { 1000 }).filter(|h| h % 2 == 1);
        let part = |h: f64| {
            let part = 4.0 * level / (std::f64::consts::PI * h * (1.0 - (h * beta).powi(2)));
            let (sin, cos) = (h * angle).sin_cos();
            part * if rate { h * beta * cos } else { sin }
        };
        orders.map(|h| part(h as f64)).sum()
    };
    // The worst is where friction turns, of the rate at once.
    let count = if rate { 1 } else { 2000 };
    let angles = (0..count).map(|i| TAU * f64::from(i) / 16_000.0);
    angles.map(left).fold(0.0, |most, one| most.max(one.abs()))
}

#[test]
fn as_many_harmonics_are_counted_as_it_takes() {
    let model = System::of::<DenHartog, _>();
    let accuracies = [1e-2, 1e-3, 1e-4];
    for (beta, level) in [(0.6, 0.2), (0.8, 0.5), (1.4, 0.3)] {
        let mut case = Case::declared(model.info(), Dynamics::Exact);
        case.parameters = vec![beta, level];
        let orbit = model.orbit(&case).expect("the response");
        let counts = model.series(&case, &orbit, &accuracies).expect("counts");
        assert_eq!(counts[2], [Some(0); 3], "a phase has no harmonics");
        for j in [0, 1] {
            let half = 0.5 * (orbit.max[j] - orbit.min[j]);
            let miss = |last| miss(last, [beta, level], j == 1) / half;
            for (count, accuracy) in counts[j].iter().zip(accuracies) {
                match *count {
                    // The first one is that of the load, too.
                    Some(1) => assert!(miss(1) <= accuracy),
                    // The nearest node misses the corner by 2 %.
                    Some(last) => assert!(
                        miss(last) <= 1.05 * accuracy && miss(last - 1) > 0.95 * accuracy,
                        "{beta} {j}: {last} for {accuracy:e}: {:e} {:e}",
                        miss(last),
                        miss(last - 1)
                    ),
                    None => assert!(miss(300) > 0.95 * accuracy),
                }
            }
        }
    }
}

/// Dynamic stiffness of the blade at a harmonic: of both masses, and between them.
fn stiffness(frequency: f64, damper: f64) -> [Complex<f64>; 3] {
    let s = Complex::new(0.0, frequency);
    let link = Complex::from(1.0) + 0.02 * s;
    [s * s + 2.0 * link + damper, s * s + link, link]
}

/// Fully stuck, the damper is a spring: the response is that of two masses.
#[test]
fn a_stuck_blade_is_linear() {
    for omega in [0.4, 0.75, 1.0, 1.7, 2.2] {
        let model = Blade {
            level: 5.0,
            omega,
            ..Blade::default()
        };
        let [inner, outer, link] = stiffness(omega, 0.5);
        let determinant = inner * outer - link * link;
        let expected = [0.1 * link / determinant, 0.1 * inner / determinant];
        let speeds = expected.map(|x| -omega * x.im);
        let [x1, x2] = expected.map(|x| x.re);
        let start = [x1, x2, speeds[0], speeds[1], 0.5 * x1, 0.0];
        let tolerance = Tolerance::for_accuracy(1e-9);
        let family = Family::from(SmoothFamily {
            model,
            smoothing: None,
            design: Design::None,
            tolerance,
            magnitude: [0.1; 6],
        });
        let place = family
            .at(0.0)
            .expect("a flow")
            .place(&start)
            .expect("a place");
        let around = Around {
            place: &place,
            period: TAU / omega,
            shift: &[],
        };
        let found = harmonics(&family, 0.0, around, &[1], tolerance)
            .expect("harmonics")
            .all;
        for (state, expected) in expected.iter().enumerate() {
            let what = format!("x{} at {omega}", state + 1);
            close(
                complex(&found[0], state),
                *expected,
                1e-9 * expected.norm(),
                &what,
            );
        }
    }
}

/// Whatever the damper does, the outer mass is linear: at each harmonic it moves with the inner one as its equation says.
#[test]
fn a_slipping_blade_obeys_its_linear_equation_at_each_harmonic() {
    let model = System::of::<Blade, _>();
    for (omega, level) in [(0.62, 0.02), (0.7, 0.05), (1.6, 0.02)] {
        let mut case = Case::declared(model.info(), Dynamics::Smooth);
        case.parameters[place(&model, "omega")] = omega;
        case.parameters[place(&model, "level")] = level;
        case.harmonics = vec![1, 3, 5];
        let orbit = model.orbit(&case).expect("the response");
        assert!(
            orbit.max[4] >= level * (1.0 - 1e-9),
            "it slips: {:?}",
            orbit.max
        );
        for harmonic in known(&orbit) {
            let [_, outer, link] = stiffness(omega * harmonic.order as f64, 0.0);
            let load = if harmonic.order == 1 { 0.1 } else { 0.0 };
            let [x1, x2] = [complex(harmonic, 0), complex(harmonic, 1)];
            let size = x1.norm().max(x2.norm()) * outer.norm();
            let what = format!("h = {} at {omega}", harmonic.order);
            close(
                outer * x2 - link * x1,
                Complex::from(load),
                1e-8 * (size + load),
                &what,
            );
        }
    }
}

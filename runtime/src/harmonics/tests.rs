use std::f64::consts::{PI, TAU};

use super::*;
use crate::field::Design;
use crate::flow::SmoothFamily;
use crate::integrate::Tolerance;
use crate::model;

model! {
    /// Two masses in a row, the second shaken: their response has a closed form.
    struct Row {
        state x = 0.0;
        state y = 0.0;
        state u = 0.0;
        state v = 0.0;
        param zeta = 0.05;
        param omega = 0.7 where omega > 0.0;
        param bias = 0.0;
        drive phi at omega;
        der(x) = u;
        der(y) = v;
        der(u) = -2 * x + y - 2 * zeta * u + zeta * v;
        der(v) = x - y + zeta * u - zeta * v + cos(phi) + 0.3 * sin(5 * phi) + bias;
    }
}

/// The response of both masses at the h-th harmonic of a force on the second, by Cramer's rule.
fn response(model: &Row, order: f64, force: Complex<f64>) -> [Complex<f64>; 2] {
    let s = Complex::new(0.0, order * model.omega);
    let entry = |k: f64, c: f64| Complex::from(k) + s * c * model.zeta;
    let (a, b, d) = (
        entry(2.0, 2.0) + s * s,
        entry(-1.0, -1.0),
        entry(1.0, 1.0) + s * s,
    );
    let determinant = a * d - b * b;
    [-b * force / determinant, a * force / determinant]
}

/// The harmonics of the response of the row, and what they should be.
fn compared(model: Row, accuracy: f64) -> Vec<(Harmonic, [Complex<f64>; 2])> {
    let forces = [
        (1, Complex::from(1.0)),
        (3, Complex::from(0.0)),
        (5, Complex::new(0.0, -0.3)),
    ];
    let expected = forces.map(|(order, force)| response(&model, f64::from(order), force));
    let mut start = [model.bias, 2.0 * model.bias, 0.0, 0.0, 0.0];
    for (both, (order, _)) in expected.iter().zip(forces) {
        for mass in 0..2 {
            start[mass] += both[mass].re;
            start[2 + mass] -= f64::from(order) * model.omega * both[mass].im;
        }
    }
    let tolerance = Tolerance::for_accuracy(accuracy);
    let family = Family::from(SmoothFamily {
        model,
        smoothing: None,
        design: Design::None,
        tolerance,
        magnitude: [1.0; 5],
    });
    let place = family.at(0.0).unwrap().place(&start).unwrap();
    let orbit = Around {
        place: &place,
        period: TAU / model.omega,
        shift: &[],
    };
    let found = harmonics(&family, 0.0, orbit, &[1, 3, 5], tolerance)
        .unwrap()
        .all;
    found.into_iter().zip(expected).collect()
}

#[test]
fn linear_responses_have_their_closed_form() {
    for omega in [1e-3, 0.2, 0.61, 0.7, 1.618, 30.0] {
        let model = Row {
            omega,
            ..Row::default()
        };
        for (found, expected) in compared(model, 1e-9) {
            for (mass, expected) in expected.iter().enumerate() {
                let (amplitude, phase) = (found.amplitude[mass], found.phase[mass]);
                let off = (Complex::from_polar(amplitude, phase) - expected).norm();
                let size = expected.norm();
                assert!(off < 1e-9 * size.max(1.0), "{omega}: {found:?} {expected}");
                if size > 0.01 {
                    let late = (phase - expected.arg()).rem_euclid(TAU);
                    assert!(late.min(TAU - late) < 1e-9, "{omega}: {found:?} {expected}");
                }
            }
        }
    }
}

/// The printed error is one: it holds at coarse accuracies, too, and beside a large rest that has no harmonics.
#[test]
fn errors_bound_what_is_off() {
    for accuracy in [1e-4, 1e-6, 1e-9] {
        for bias in [0.0, 1e3] {
            let model = Row {
                bias,
                ..Row::default()
            };
            for (found, expected) in compared(model, accuracy) {
                for (mass, expected) in expected.iter().enumerate() {
                    let value = Complex::from_polar(found.amplitude[mass], found.phase[mass]);
                    let off = (value - expected).norm();
                    let error = found.error[mass];
                    assert!(
                        off <= error + 1e-12,
                        "{accuracy:e} {bias}: {off:e} {error:e}"
                    );
                    assert!(error < 1e3 * accuracy * (1.0 + bias), "{error:e}");
                }
            }
        }
    }
}

model! {
    /// x = cos t from its declared start, without a drive.
    struct Swing {
        state x = 1.0;
        state v = 0.0;
        param k = 1.0;
        der(x) = v;
        der(v) = -k * x;
    }
}

#[test]
fn an_orbit_without_a_drive_is_its_own_clock() {
    let tolerance = Tolerance::for_accuracy(1e-9);
    let family = Family::from(SmoothFamily {
        model: Swing::default(),
        smoothing: None,
        design: Design::None,
        tolerance,
        magnitude: [1.0; 2],
    });
    let place = family.at(0.0).unwrap().place(&[1.0, 0.0]).unwrap();
    let around = Around {
        place: &place,
        period: TAU,
        shift: &[],
    };
    let found = harmonics(&family, 0.0, around, &[1, 2], tolerance)
        .unwrap()
        .all;
    assert!((found[0].amplitude[0] - 1.0).abs() < 1e-10 && found[0].phase[0].abs() < 1e-10);
    assert!((found[0].phase[1] - 0.5 * PI).abs() < 1e-10, "{found:?}");
    assert!(found[1].amplitude[0] < 1e-10, "{found:?}");
}

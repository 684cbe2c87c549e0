use super::*;
use crate::examples::{Belt, Pair};
use crate::field::SmoothField;
use crate::flow::SmoothFlow;
use crate::flow::exact::ExactFlow;
use crate::integrate::Tolerance;
use crate::model;
use crate::model::Model;

model! {
    /// A damped oscillator beside a state that decays faster: its exponents are −0.05, −0.05 and −2.
    struct Damped {
        state x = 1.0;
        state v = 0.0;
        state u = 1.0;
        param c = 0.1;
        der(x) = v;
        der(v) = -x - c * v;
        der(u) = -2.0 * u;
    }
}

model! {
    /// The unit circle, on which others lie near it at the rates −2 and −0.1.
    struct Circle {
        state x = 1.0;
        state v = 0.0;
        state u = 0.0;
        param p = -0.1;
        der(x) = x * (1.0 - powi(x, 2) - powi(v, 2)) - v;
        der(v) = v * (1.0 - powi(x, 2) - powi(v, 2)) + x;
        der(u) = p * u;
    }
}

model! {
    /// Lorenz (1963).
    struct Lorenz {
        state x = 1.0;
        state y = 1.0;
        state z = 20.0;
        param sigma = 10.0;
        param rho = 28.0;
        param beta = 2.666_666_666_666_666_5;
        der(x) = sigma * (y - x);
        der(y) = x * (rho - z) - y;
        der(z) = x * y - beta * z;
    }
}

model! {
    /// Rössler (1976) at his chaotic values.
    struct Roessler {
        state x = 1.0;
        state y = 1.0;
        state z = 0.0;
        param a = 0.2;
        param b = 0.2;
        param c = 5.7;
        der(x) = -y - z;
        der(y) = x + a * y;
        der(z) = b + z * (x - c);
    }
}

fn smooth<M: Model<N>, const N: usize>(accuracy: f64) -> SmoothFlow<M, N> {
    let field = SmoothField::new(&M::default(), None, Default::default()).unwrap();
    SmoothFlow::new(field, Tolerance::for_accuracy(accuracy))
}

/// After a time for the transient to die out.
fn exponent<M: Model<N>, const N: usize>(lap: f64, laps: usize) -> Lyapunov {
    let flow = smooth::<M, N>(1e-8);
    let start: Vec<f64> = M::INFO.states.iter().map(|state| state.start).collect();
    let settled = flow.advance(&flow.place(&start).unwrap(), 50.0, Want::default());
    lyapunov(&flow, settled.unwrap().end, lap, laps).unwrap()
}

#[test]
fn a_damped_motion_decays_at_its_damping() {
    let flow = smooth::<Damped, 3>(1e-12);
    let start = flow.place(&[1.0, 0.0, 1.0]).unwrap();
    let turn = std::f64::consts::TAU / (1.0_f64 - 0.05 * 0.05).sqrt();
    let found = lyapunov(&flow, start, turn, 10).unwrap();
    assert!((found.exponent.unwrap() + 0.05).abs() < 1e-6, "{found:?}");
}

#[test]
fn across_an_orbit_the_exponent_zero_is_left_out() {
    let found = exponent::<Circle, 3>(std::f64::consts::TAU, 40);
    assert!((found.exponent.unwrap() + 0.1).abs() < 1e-9, "{found:?}");
}

/// 0.9056 and 0.0714: Sprott, *Chaos and Time-Series Analysis* (2003).
#[test]
fn published_exponents_lie_within_the_error() {
    for (name, found, published) in [
        ("Lorenz", exponent::<Lorenz, 3>(1.0, 4000), 0.9056),
        ("Rössler", exponent::<Roessler, 3>(6.0, 3000), 0.0714),
    ] {
        let value = found.exponent.unwrap();
        assert!(found.error < 0.03 * published, "{name}: {found:?}");
        assert!(
            (value - published).abs() < 3.0 * found.error + 5e-5,
            "{name}: {found:?}"
        );
    }
}

#[test]
fn one_mass_that_sticks_is_superstable() {
    let tolerance = Tolerance::for_accuracy(1e-9).explicit();
    let flow = ExactFlow::new(&Belt::default(), None, tolerance).unwrap();
    let start = flow.place(&[1.0, 0.2]).unwrap();
    let found = lyapunov(&flow, start, 12.0, 20).unwrap();
    assert_eq!(found.exponent, None);
}

/// Two masses keep one direction that sticking does not take away.
#[test]
fn two_masses_that_stick_are_not() {
    let tolerance = Tolerance::for_accuracy(1e-9).explicit();
    let flow = ExactFlow::new(&Pair::default(), None, tolerance).unwrap();
    let start = flow.place(&[-0.5976, 0.0, -0.4604, -0.1607]).unwrap();
    let settled = flow.advance(&start, 400.0, Want::default()).unwrap().end;
    let found = lyapunov(&flow, settled, 16.0, 50).unwrap();
    assert!(found.exponent.is_some_and(|value| value < 0.0), "{found:?}");
}

#[test]
fn errors_of_correlated_series_are_not_underestimated() {
    let pairs: Vec<f64> = (0..64).flat_map(|k| [f64::from(k % 2); 8]).collect();
    let naive = independent(&pairs);
    assert!(standard_error(&pairs) > 2.0 * naive);
    assert_eq!(standard_error(&[1.0]), f64::INFINITY);
}

//! Generated right-hand sides, Jacobians and parameter derivatives, by dual numbers and written out, against the
//! hand-written ones, at random
//! states and parameters: they agree to a few units in the last place of the terms that are summed.

use stickslip::field::{Kernel, Smoothing};
use stickslip::friction::{ContactRule, FrictionLaw};
use stickslip::model::Model;
use stickslip::scalar::Scalar;
use stickslip_models::{BeltOscillator, BeltPair, DrillString, VanDerPol};
use stickslip_tests::hand_written::{self, BeltForce, Linearised, belt_force};
use stickslip_tests::lanes::{linearised, tangents};
use stickslip_tests::random::Random;

const SAMPLES: usize = 4000;

/// (3.6): the sign of the speed becomes (2/π) arctan εw.
#[derive(Clone)]
struct Arctan(f64);

impl<D: Scalar> ContactRule<D> for Arctan {
    fn force<L: FrictionLaw<D>>(&mut self, _contact: usize, law: &L, speed: D) -> D {
        -law.slip(speed.abs()) * (speed * self.0).atan() * (2.0 / std::f64::consts::PI)
    }
}

/// (4.7): a bump of width ε above the kinetic curve, for positive speeds.
#[derive(Clone)]
struct Quartic(f64);

impl<D: Scalar> ContactRule<D> for Quartic {
    fn force<L: FrictionLaw<D>>(&mut self, _contact: usize, law: &L, speed: D) -> D {
        let (kinetic, u) = (law.slip(speed), speed / self.0);
        if u.re() > 4.0 {
            return -kinetic;
        }
        let rest = -u + 4.0;
        -kinetic - (law.stick() - kinetic) * u * rest * rest * rest / 27.0
    }
}

fn arctan(size: f64) -> Option<Smoothing> {
    let kernel = Kernel::Arctan;
    Some(Smoothing { kernel, size })
}

fn quartic(size: f64) -> Option<Smoothing> {
    let kernel = Kernel::Quartic;
    Some(Smoothing { kernel, size })
}

/// Compares every number; `sizes` holds the sums of the magnitudes of the terms of each.
fn assert_equal<const N: usize, const P: usize>(
    found: &Linearised<N, P>,
    expected: &Linearised<N, P>,
    sizes: &Linearised<N, P>,
) {
    let rows = |l: &Linearised<N, P>| -> Vec<f64> {
        let parameters = l.by_parameter.as_flattened();
        [&l.f, l.jacobian.as_flattened(), parameters].concat()
    };
    let (found, expected, sizes) = (rows(found), rows(expected), rows(sizes));
    for (i, ((found, expected), size)) in found.iter().zip(expected).zip(sizes).enumerate() {
        let tolerance = 4.0 * f64::EPSILON * size;
        assert!(
            (found - expected).abs() <= tolerance,
            "number {i}: {found:e}, by hand {expected:e}, tolerance {tolerance:e}"
        );
    }
}

#[test]
fn van_der_pol() {
    let mut random = Random::new(1);
    for _ in 0..SAMPLES {
        let (nu, x, v) = (
            random.positive(1e-3, 1e3),
            random.real(5.0),
            random.real(20.0),
        );
        let found = linearised::<VanDerPol, 2, 1>(&VanDerPol { nu }, [x, v], Arctan(1.0));
        let written = tangents::<VanDerPol, 2, 1>(&VanDerPol { nu }, [x, v], None);
        let damping = x * x + 1.0;
        let sizes = Linearised {
            f: [v, nu * damping * v + x].map(f64::abs),
            jacobian: [[0.0, 1.0], [(2.0 * nu * x * v).abs() + 1.0, nu * damping]],
            by_parameter: [[0.0, (damping * v).abs()]],
        };
        assert_equal(&found, &hand_written::van_der_pol([nu], [x, v]), &sizes);
        assert_equal(&written, &hand_written::van_der_pol([nu], [x, v]), &sizes);
        assert_equal(&written, &found, &sizes);
    }
}

/// The sizes of a belt force and of its derivatives.
fn force_sizes(limit: f64, decay: f64, eps: f64, speed: f64) -> BeltForce {
    let exact = belt_force(limit, decay, eps, speed);
    let stiff = belt_force(limit, 0.0, eps, speed).by_speed.abs();
    BeltForce {
        force: exact.force.abs(),
        by_speed: stiff + (exact.force * decay).abs(),
        by_limit: exact.by_limit.abs(),
        by_decay: exact.by_decay.abs(),
    }
}

#[test]
fn belt_oscillator() {
    let mut random = Random::new(2);
    for _ in 0..SAMPLES {
        let [m, k, limit, delta] = random.array(|random| random.positive(1e-2, 1e2));
        let (eps, v_dr) = (random.positive(1.0, 1e7), random.real(1.0));
        let (x, v) = (random.real(2.0), v_dr + random.signed(1e-9, 10.0));
        let model = BeltOscillator {
            m,
            k,
            v_dr,
            F_s: limit,
            delta,
        };
        let found = linearised::<BeltOscillator, 2, 5>(&model, [x, v], Arctan(eps));
        let written = tangents::<BeltOscillator, 2, 5>(&model, [x, v], arctan(eps));
        let expected = hand_written::belt_oscillator(model.values(), eps, [x, v]);
        let friction = force_sizes(limit, delta, eps, v - v_dr);
        let acceleration = (friction.force + (k * x).abs()) / m;
        let sizes = Linearised {
            f: [v.abs(), acceleration],
            jacobian: [[0.0, 1.0], [k / m, friction.by_speed / m]],
            by_parameter: [
                [0.0, acceleration / m],
                [0.0, x.abs() / m],
                [0.0, friction.by_speed / m],
                [0.0, friction.by_limit / m],
                [0.0, friction.by_decay / m],
            ],
        };
        assert_equal(&found, &expected, &sizes);
        assert_equal(&written, &expected, &sizes);
        assert_equal(&written, &found, &sizes);
    }
}

#[test]
fn belt_pair() {
    let mut random = Random::new(3);
    for _ in 0..SAMPLES {
        let [alpha, beta, gamma] = random.array(|random| random.positive(1e-2, 1e2));
        let (eps, v_dr) = (random.positive(1.0, 1e7), random.real(1.0));
        let [x1, x2] = random.array(|random| random.real(2.0));
        let [v1, v2] = random.array(|random| v_dr + random.signed(1e-9, 10.0));
        let (model, state) = (
            BeltPair {
                alpha,
                beta,
                gamma,
                v_dr,
            },
            [x1, v1, x2, v2],
        );
        let found = linearised::<BeltPair, 4, 4>(&model, state, Arctan(eps));
        let written = tangents::<BeltPair, 4, 4>(&model, state, arctan(eps));
        let expected = hand_written::belt_pair(model.values(), eps, state);
        let first = force_sizes(1.0, gamma, eps, v1 - v_dr);
        let second = force_sizes(beta, gamma, eps, v2 - v_dr);
        let coupling = (alpha * (x1 - x2)).abs();
        let stretch = x1.abs() + x2.abs();
        let sizes = Linearised {
            f: [
                v1.abs(),
                x1.abs() + coupling + first.force,
                v2.abs(),
                x2.abs() + coupling + second.force,
            ],
            jacobian: [
                [0.0, 1.0, 0.0, 0.0],
                [1.0 + alpha, first.by_speed, alpha, 0.0],
                [0.0, 0.0, 0.0, 1.0],
                [alpha, 0.0, 1.0 + alpha, second.by_speed],
            ],
            by_parameter: [
                [0.0, stretch, 0.0, stretch],
                [0.0, 0.0, 0.0, second.by_limit],
                [0.0, first.by_decay, 0.0, second.by_decay],
                [0.0, first.by_speed, 0.0, second.by_speed],
            ],
        };
        assert_equal(&found, &expected, &sizes);
        assert_equal(&written, &expected, &sizes);
        assert_equal(&written, &found, &sizes);
    }
}

#[test]
fn drill_string() {
    let mut random = Random::new(4);
    for _ in 0..SAMPLES {
        let [eta, theta, kinetic] = random.array(|random| random.positive(1e-1, 1e1));
        let (zeta, eps) = (random.positive(1e-3, 1.0), random.positive(1e-4, 1.0));
        let (psi, u) = (random.real(10.0), random.real(1.0) * 4.0 + 3.5);
        let (omega, model) = (
            eta - eps * u,
            DrillString {
                eta,
                theta,
                kinetic,
                zeta,
            },
        );
        let found = linearised::<DrillString, 2, 4>(&model, [psi, omega], Quartic(eps));
        let written = tangents::<DrillString, 2, 4>(&model, [psi, omega], quartic(eps));
        let expected = hand_written::drill_string(model.values(), eps, [psi, omega]);
        let rest = 4.0 + u.abs();
        let bump = u.abs() * rest * rest * rest / 27.0;
        let rate = 4.0 * (1.0 + u.abs()) * rest * rest / (27.0 * eps);
        let torque = (theta + kinetic) * bump + kinetic;
        let sizes = Linearised {
            f: [omega.abs(), (2.0 * zeta * omega).abs() + psi.abs() + torque],
            jacobian: [[0.0, 1.0], [1.0, 2.0 * zeta + (theta + kinetic) * rate]],
            by_parameter: [
                [0.0, (theta + kinetic) * rate],
                [0.0, bump],
                [0.0, bump + 1.0],
                [0.0, 2.0 * omega.abs()],
            ],
        };
        assert_equal(&found, &expected, &sizes);
        assert_equal(&written, &expected, &sizes);
        assert_equal(&written, &found, &sizes);
    }
}

#[test]
fn at_rest_the_sign_is_that_of_the_zero() {
    let model = BeltOscillator::default();
    let found = linearised::<BeltOscillator, 2, 5>(&model, [1.0, model.v_dr], Arctan(1e3));
    let written = tangents::<BeltOscillator, 2, 5>(&model, [1.0, model.v_dr], arctan(1e3));
    let expected = hand_written::belt_oscillator(model.values(), 1e3, [1.0, model.v_dr]);
    assert_equal(&found, &expected, &expected.map(f64::abs));
    assert_equal(&written, &expected, &expected.map(f64::abs));
}

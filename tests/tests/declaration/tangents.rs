//! Derivatives that the macro has written out, against dual numbers, where a declaration uses all that it may.

use stickslip::field::Smoothing;
use stickslip::friction::{ContactRule, FrictionLaw};
use stickslip::model::Model;
use stickslip::scalar::Scalar;
use stickslip::{friction_law, model};
use stickslip_tests::hand_written::Linearised;
use stickslip_tests::lanes::{linearised, tangents};
use stickslip_tests::random::Random;

friction_law! {
    /// Uses its fields and its speed in every place.
    struct Curved {
        param level: N where level >= 0.0;
        param pace: m/s where pace > 0.0;
        param shape: 1 where shape >= 1.0;
        stick = 2 * level / 2;
        slip(s) = level * exp(-powf(s / pace, shape)) + (1 - 1 / (1 + s / pace)) * level;
    }
}

model! {
    /// Every function, `let` lines above `let` lines, a law that reads states, and a parameter inside a speed.
    struct Everything {
        state x = 0.5;
        state y = 0.3;
        state w = 0.1;
        state z = 0.2;
        param p = 1.5 where p > 0.0;
        param q = 0.7 where q > 0.0;
        param belt = 0.2;
        let near = x * y / (1 + q * x);
        let load = 2 - sin(near) - -p * powi(y, 2);
        friction held = Curved { level: load, pace: q + x * x, shape: p } opposing w - belt * p - 0.1 * x;
        friction plain = Curved { level: 1.0, pace: 2.0, shape: 2.0 } opposing belt - z;
        let inverse = acos(x) + asin(y * q) + atan(p * x) + acosh(1 + x) + asinh(-x) + atanh(x * y);
        let forward = cos(x - y) + sin(p * x) + tan(0.5 * y) + cosh(w) + sinh(x * x) + tanh(q * z);
        let powers = powi(x, 3) + powi(x + y, -2) + powf(x, 2.5) + powf(y, p) + powf(2, x) + powf(x * p, q * y)
            + powi(x, 0) + powi(x, 1) + powf(x, 3) + powi(y, -1);
        let others = exp(-x) * ln(y) / sqrt(x + q) - std::f64::consts::PI / x + near * (3 - 2) / 4;
        der(x) = w;
        der(w) = (held - plain * near) / (p + x) - powers;
        der(y) = -(inverse - forward) * others + (x - x * 1);
        der(z) = plain + 3.0 - 2 * z;
    }
}

/// tanh of the speed times the size.
#[derive(Clone)]
struct Tanh(f64);

impl<D: Scalar> ContactRule<D> for Tanh {
    fn force<L: FrictionLaw<D>>(&mut self, _contact: usize, law: &L, speed: D) -> D {
        -law.slip(speed.abs()) * stickslip::math::tanh(speed * self.0)
    }
}

fn numbers<const N: usize, const P: usize>(all: &Linearised<N, P>) -> Vec<f64> {
    let by_parameter = all.by_parameter.as_flattened();
    [&all.f, all.jacobian.as_flattened(), by_parameter].concat()
}

#[test]
fn everything() {
    let mut random = Random::new(5);
    for _ in 0..4000 {
        let model = Everything {
            p: random.positive(1.0, 2.0),
            q: random.positive(0.3, 1.0),
            belt: random.real(0.5),
        };
        let state = [
            random.positive(0.1, 0.9),
            random.positive(0.1, 0.9),
            random.real(1.0),
            random.real(1.0),
        ];
        let found = tangents::<Everything, 4, 3>(&model, state, smooth());
        let expected = linearised::<Everything, 4, 3>(&model, state, Tanh(7.0));
        assert_eq!(found.f, expected.f);
        // The largest terms that are summed in any entry.
        let size = 1e3;
        for (i, (a, b)) in numbers(&found).iter().zip(numbers(&expected)).enumerate() {
            let tolerance = 4.0 * f64::EPSILON * (size + b.abs());
            assert!(
                (a - b).abs() <= tolerance,
                "number {i}: {a:e}, by lanes {b:e}"
            );
        }
    }
}

#[test]
fn only_what_is_read_can_differ_from_zero() {
    let model = Everything::default();
    let found = tangents::<Everything, 4, 3>(&model, [0.5, 0.3, 0.1, 0.2], smooth());
    for (row, reads) in found.jacobian.iter().zip(Everything::SPARSITY) {
        for (entry, read) in row.iter().zip(reads) {
            assert_eq!(*entry != 0.0, read, "{:?}", found.jacobian);
        }
    }
    assert_eq!(found.jacobian[0], [0.0, 0.0, 1.0, 0.0]);
}

fn smooth() -> Option<Smoothing> {
    "tanh:7".parse().ok()
}

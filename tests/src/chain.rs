//! Chains of masses, declared over an index, and written by hand.

use stickslip::model;
use stickslip_models::friction::Weakening;

use crate::hand_written::belt_force;

/// A chain of masses between walls, each rubbing on a belt: nondimensional.
macro_rules! chain {
    ($(#[$doc:meta])* $name:ident, $masses:literal, $inner:literal) => {
        model! {
            $(#[$doc])*
            pub struct $name {
                state x[$masses] = 0.1;
                state v[$masses] = 0.0;
                param k = 1.3 where k > 0.0;
                param v_dr = 0.2;
                param limit = 0.4 where limit >= 0.0;
                param decay = 2.0 where decay >= 0.0;
                for i in 0..$masses {
                    friction F[i] = Weakening { limit, decay } opposing v[i] - v_dr;
                    der(x[i]) = v[i];
                }
                der(v[0]) = F[0] - k * (2 * x[0] - x[1]);
                for i in 1..$inner {
                    der(v[i]) = F[i] - k * (2 * x[i] - x[i - 1] - x[i + 1]);
                }
                der(v[$inner]) = F[$inner] - k * (2 * x[$inner] - x[$inner - 1]);
            }
        }
    };
}

chain! {
    /// Ten masses.
    Chain10, 10, 9
}
chain! {
    /// Twenty masses.
    Chain20, 20, 19
}
chain! {
    /// Fifty masses.
    Chain50, 50, 49
}
chain! {
    /// A hundred masses.
    Chain100, 100, 99
}

/// f, the entries of the Jacobian that can differ from zero, and ∂f/∂v_dr, of a chain whose friction is smoothed by
/// arctan of the size `size`: by hand, the parameters in the order of their declaration.
#[inline]
pub fn by_hand<const N: usize>(
    [k, v_dr, limit, decay]: [f64; 4],
    size: f64,
    state: &[f64; N],
    mut entry: impl FnMut(usize, usize, f64),
) -> ([f64; N], [f64; N]) {
    let masses = N / 2;
    let (mut f, mut by_belt) = ([0.0; N], [0.0; N]);
    for i in 0..masses {
        let (x, v) = (state[i], state[masses + i]);
        let left = if i > 0 { state[i - 1] } else { 0.0 };
        let right = if i + 1 < masses { state[i + 1] } else { 0.0 };
        let friction = belt_force(limit, decay, size, v - v_dr);
        let (force, slope) = (friction.force, friction.by_speed);
        f[i] = v;
        entry(i, masses + i, 1.0);
        let row = masses + i;
        f[row] = force - k * (2.0 * x - left - right);
        if i > 0 {
            entry(row, i - 1, k);
        }
        entry(row, i, -2.0 * k);
        if i + 1 < masses {
            entry(row, i + 1, k);
        }
        entry(row, row, slope);
        by_belt[row] = -slope;
    }
    (f, by_belt)
}

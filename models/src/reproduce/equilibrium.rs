//! Equilibria of smooth copies: stable where the real one is not, or the other way round.

use stickslip::field::{Field, Kernel};
use stickslip::model::Model;
use stickslip::report::Curve;

use super::ReproduceError;
use super::follow::field;

/// Series of stable equilibria: a solid line; of unstable ones: a dashed line.
const SERIES: [usize; 2] = [6, 1];

/// Trace of the Jacobian at an equilibrium of a copy of two states: it is stable where this is negative.
///
/// The determinant is the stiffness, which is positive: the eigenvalues cannot be real and of different sign.
pub(super) fn trace<M: Model<2>>(
    model: &M,
    (kernel, size): (Kernel, f64),
    state: [f64; 2],
) -> Result<f64, ReproduceError> {
    let field = field(model, kernel, size).map_err(ReproduceError::at("an equilibrium"))?;
    let [[a, _], [_, d]] = field.linearise(&state).jacobian;
    Ok(a + d)
}

/// Where `f` changes sign between `low` and `high`.
pub(super) fn sign_change(
    f: impl Fn(f64) -> Result<f64, ReproduceError>,
    mut low: f64,
    mut high: f64,
) -> Result<f64, ReproduceError> {
    let below = f(low)? > 0.0;
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if (f(middle)? > 0.0) == below {
            low = middle;
        } else {
            high = middle;
        }
    }
    Ok(0.5 * (low + high))
}

/// Equilibria at parameters `from` to `to`, in one piece.
pub(super) fn piece(
    at: impl Fn(f64) -> f64,
    (from, to): (f64, f64),
    stable: bool,
    label: &str,
) -> Curve {
    let points = (0..=200)
        .map(|i| from + (to - from) * f64::from(i) / 200.0)
        .map(|r| [r, at(r)])
        .collect();
    Curve::line(label, SERIES[usize::from(!stable)], points)
}

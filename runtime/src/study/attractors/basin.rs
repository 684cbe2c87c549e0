//! A region around a stable equilibrium in which a Lyapunov function falls.

use nalgebra::{DMatrix, DVector};

use crate::math::interval::Interval;
use crate::motion::Enclosure;

/// Sizes of the region that are tried, each half the one before.
const HALVINGS: usize = 40;
/// States beyond which the equations of the function are too many.
const MOST: usize = 12;
/// What rounding errors of eigenvalues are allowed, relative to the largest entry.
const ROUNDING: f64 = 1e-9;

/// δᵀQδ ≤ c around an equilibrium: there δᵀQδ falls along every motion.
#[derive(Debug, Clone)]
pub(super) struct Basin {
    state: DVector<f64>,
    form: DMatrix<f64>,
    level: f64,
}

impl Basin {
    /// The largest one that is found, no larger than `usual` sizes of the states.
    ///
    /// f(y + δ) = J δ with J a mean of Jacobians between y and y + δ. Where QJ + JᵀQ is negative definite for all
    /// matrices between the bounds of the Jacobian over a box, δᵀQδ falls in each ellipsoid inside that box.
    pub(super) fn around(
        field: &dyn Enclosure,
        (state, jacobian): (&[f64], &DMatrix<f64>),
        usual: &[f64],
    ) -> Option<Self> {
        let form = form(jacobian)?;
        let inverse = form.clone().try_inverse()?;
        let reach: Vec<f64> = (0..usual.len()).map(|j| inverse[(j, j)].sqrt()).collect();
        let pairs = reach.iter().zip(usual);
        let most = pairs
            .map(|(reach, usual)| usual / reach)
            .fold(f64::INFINITY, f64::min);
        let falls = |size: &f64| {
            let sides = state.iter().zip(&reach);
            let box_of: Vec<Interval> = sides
                .map(|(y, reach)| Interval::around(*y, size * reach))
                .collect();
            field
                .over(&box_of)
                .is_ok_and(|over| is_negative(&form, &over.jacobian))
        };
        let sizes = (0..HALVINGS).map(|k| most * 0.5_f64.powi(k as i32));
        let size = sizes.into_iter().find(falls)?;
        // Between the largest that holds and the smallest that does not.
        let size = [1.8, 1.6, 1.4, 1.2]
            .map(|more| more * size)
            .into_iter()
            .find(falls)
            .unwrap_or(size);
        Some(Self {
            state: DVector::from_column_slice(state),
            form,
            level: size * size,
        })
    }

    /// Whether a state lies in it.
    pub(super) fn holds(&self, state: &[f64]) -> bool {
        let off = DVector::from_column_slice(state) - &self.state;
        (&self.form * &off).dot(&off) <= self.level
    }
}

/// Q with QJ + JᵀQ = −1, positive definite; `None` unless J is stable.
fn form(jacobian: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let n = jacobian.nrows();
    if n > MOST {
        return None;
    }
    let mut equations = DMatrix::zeros(n * n, n * n);
    for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
        for k in 0..n {
            equations[(i * n + j, i * n + k)] += jacobian[(k, j)];
            equations[(i * n + j, k * n + j)] += jacobian[(k, i)];
        }
    }
    let right = DVector::from_fn(n * n, |e, _| if e / n == e % n { -1.0 } else { 0.0 });
    let solved = equations.lu().solve(&right)?;
    let form = DMatrix::from_fn(n, n, |i, j| 0.5 * (solved[i * n + j] + solved[j * n + i]));
    let positive = form.clone().cholesky().is_some();
    positive.then_some(form)
}

/// Whether QJ + JᵀQ is negative definite for all J between these bounds: the largest eigenvalue of its middle, and what
/// the rest can add to it.
fn is_negative(form: &DMatrix<f64>, jacobian: &[Vec<Interval>]) -> bool {
    let n = form.nrows();
    let middle = DMatrix::from_fn(n, n, |i, j| jacobian[i][j].middle());
    let radius = DMatrix::from_fn(n, n, |i, j| {
        let slope = jacobian[i][j];
        (slope.high() - middle[(i, j)]).max(middle[(i, j)] - slope.low())
    });
    if !middle.iter().chain(&radius).all(|entry| entry.is_finite()) {
        return false;
    }
    let both = |product: DMatrix<f64>| &product + product.transpose();
    let (middle, rest) = (both(form * middle), both(form.abs() * radius));
    let rounding = ROUNDING * middle.amax().max(rest.amax());
    let largest = |matrix: DMatrix<f64>| matrix.symmetric_eigenvalues().max();
    largest(middle) + largest(rest) + rounding < 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::Unenclosed;
    use crate::motion::Enclosed;

    /// x' = v, v' = −x − 0.1 v + v³: it draws in from within, and drives away from without, an orbit near v = 0.365.
    struct Cubic;

    impl Enclosure for Cubic {
        fn order(&self) -> usize {
            2
        }

        fn over(&self, states: &[Interval]) -> Result<Enclosed, Unenclosed> {
            let number = Interval::from;
            let v = states[1];
            let square = Interval::new(0.0, v.magnitude() * v.magnitude());
            Ok(Enclosed {
                f: vec![v, number(0.0)],
                jacobian: vec![
                    vec![number(0.0), number(1.0)],
                    vec![number(-1.0), square * number(3.0) - number(0.1)],
                ],
            })
        }
    }

    #[test]
    fn the_basin_is_inside_that_of_the_motion() {
        let jacobian = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -1.0, -0.1]);
        let basin = Basin::around(&Cubic, (&[0.0, 0.0], &jacobian), &[2.0, 2.0]).unwrap();
        // The unstable orbit, by harmonic balance: 0.1 = 3/4 v².
        assert!(!basin.holds(&[0.0, 0.365]));
        assert!(basin.holds(&[0.0, 0.1]), "{basin:?}");
    }
}

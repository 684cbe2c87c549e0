//! The small orbits that begin at a Hopf point of an equilibrium.

use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector};

use super::branch::OrbitBranch;
use super::division::Division;
use super::problem::OrbitProblem;
use super::sought::Search;
use super::switch::SwitchError;
use crate::continuation::{Branch, Failure, Settings};
use crate::integrate::Tolerance;
use crate::linear::{svd, units};
use crate::motion::Family;

/// Amplitudes of the first orbit, relative to the state; for a state near 0, against 1.
const AMPLITUDES: [f64; 3] = [1e-2, 1e-3, 1e-1];

impl OrbitBranch {
    /// The branch of orbits that begins where, at r, an equilibrium has a pair of eigenvalues ± iω with
    /// the period 2π/ω: its first orbit is an ellipse in the plane of their eigenvectors.
    ///
    /// # Errors
    /// See [`SwitchError`].
    pub fn from_hopf(
        family: &Family,
        (r, state): (f64, &[f64]),
        period: f64,
        search: &Search,
        settings: Settings,
    ) -> Result<Self, SwitchError> {
        let size = state.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let size = if size > 1e-3 { size } else { 1.0 };
        let (order, mut last) = (state.len(), SwitchError::NotFound);
        let sharp = family.with_tolerance(Tolerance::for_accuracy(search.accuracy));
        let flow = sharp.at(r).map_err(Failure::Evaluation)?;
        let centre = flow.place(state).map_err(Failure::Evaluation)?;
        let jacobian = flow
            .velocity(&centre)
            .map_err(Failure::Evaluation)?
            .jacobian;
        let (axis, extents) = ellipse(&jacobian, period).ok_or(SwitchError::NotFound)?;
        for amplitude in AMPLITUDES {
            let magnitude: Vec<f64> = extents
                .iter()
                .map(|extent| amplitude * size * extent)
                .collect();
            let family = sharp.with_magnitude(&magnitude);
            let flow = family.at(r).map_err(Failure::Evaluation)?;
            let mut start = centre.clone();
            for j in 0..order {
                start.state[j] += amplitude * size * axis[j];
            }
            let velocity = flow.velocity(&start).map_err(Failure::Evaluation)?.f;
            let phase = super::Phase::orthogonal(start.state.clone(), &velocity, &magnitude);
            let whole = Division::whole(start);
            let problem = OrbitProblem::new(family, phase, &whole, period, magnitude);
            let z = OrbitProblem::unknowns(&whole.starts, period);
            let mut direction = DVector::zeros(order + 2);
            direction.rows_mut(0, order).copy_from(&axis);
            match Branch::set_out(problem, (z, r), (&direction, 1.0), settings) {
                Ok(started) => return Ok(Self::begin(started, search.accuracy)),
                Err(failure) => last = failure.into(),
            }
        }
        Err(last)
    }
}

/// The least extent of a state over the largest, in units in which each moves the others as much as they move it: about which
/// mean it swings may change by more than a state that hardly does so swings.
const LEAST: f64 = 0.1;

/// The ellipse a cos ωt − b sin ωt: a, and the extent of each state along it.
fn ellipse(jacobian: &DMatrix<f64>, period: f64) -> Option<(DVector<f64>, Vec<f64>)> {
    let axis = axis(jacobian, period)?;
    // J a = −ω b.
    let other = jacobian * &axis * (period / TAU);
    let extents = axis.iter().zip(&other).map(|(a, b)| a.hypot(*b));
    let mut extents: Vec<f64> = extents.collect();
    let units = units(jacobian);
    let shares = extents
        .iter()
        .zip(&units)
        .map(|(extent, unit)| extent / unit);
    let largest = shares.fold(0.0, f64::max);
    for (extent, unit) in extents.iter_mut().zip(&units) {
        *extent = extent.max(LEAST * largest * unit);
    }
    Some((axis, extents))
}

/// The real part a of the eigenvector a + ib for iω: J a = −ω b, J b = ω a.
fn axis(jacobian: &DMatrix<f64>, period: f64) -> Option<DVector<f64>> {
    let order = jacobian.nrows();
    let omega = TAU / period;
    let matrix = DMatrix::from_fn(2 * order, 2 * order, |i, j| match (i < order, j < order) {
        (true, true) => jacobian[(i, j)],
        (false, false) => jacobian[(i - order, j - order)],
        (true, false) => omega * f64::from(i + order == j),
        (false, true) => -omega * f64::from(i == j + order),
    });
    let svd = svd(matrix)?;
    let least = svd.singular_values.imin();
    let row = svd.v_t?.row(least).transpose();
    let axis = row.rows(0, order).into_owned();
    axis.iter()
        .all(|x| x.is_finite())
        .then(|| axis.try_normalize(0.0))
        .flatten()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_plane_of_an_oscillation_is_found() {
        // x' = 2 y, y' = −2 x, and z decays: the axis lies in the plane of x and y.
        let rows = [0.0, 2.0, 0.0, -2.0, 0.0, 0.0, 0.0, 0.0, -1.0];
        let jacobian = DMatrix::from_row_slice(3, 3, &rows);
        let axis = axis(&jacobian, std::f64::consts::PI).unwrap();
        assert!(axis[2].abs() < 1e-14 && (axis.norm() - 1.0).abs() < 1e-14);
    }
}

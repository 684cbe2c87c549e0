//! A structure reduced by each of the methods.

use nalgebra::{Cholesky, DMatrix, SymmetricEigen};

use super::error::ReduceError;
use super::factor::Ordering;
use super::method::Method;
use super::modes::modes;
use super::pencil::Pencil;
use super::place::Point;
use super::projection::{Reduced, projected};
use super::residual::displacements;
use super::structure::{Structure, damped};

/// Reduces a structure to its `wanted` lowest modes and what its points need besides.
///
/// # Errors
/// The matrices are those of no structure, a point is nowhere, or there are fewer modes.
pub fn reduce(
    pencil: &Pencil,
    points: &[Point],
    wanted: usize,
    method: Method,
) -> Result<Structure, ReduceError> {
    let at = pencil.at(points)?;
    let reduced = match method {
        Method::Free => free(pencil, &at, wanted, true)?,
        Method::Massless => free(pencil, &at, wanted, false)?,
        Method::CraigBampton => craig_bampton(pencil, &at, wanted)?,
    };
    damped(pencil, points, &at, method, reduced)
}

/// What is left of a flexibility when nothing is left out.
const NOTHING: f64 = 1e-12;

fn free(
    pencil: &Pencil,
    at: &[usize],
    wanted: usize,
    with_mass: bool,
) -> Result<Reduced, ReduceError> {
    let ordering = Ordering::of(pencil)?;
    let modes = modes(pencil, &ordering, wanted)?;
    let made = displacements(pencil, &modes, at)?;
    let mut residual = made.select_rows(at);
    residual = (&residual + residual.transpose()) / 2.0;
    for (k, &unknown) in at.iter().enumerate() {
        let strained = modes
            .values
            .iter()
            .enumerate()
            .filter(|(_, value)| **value > 0.0);
        let kept: f64 = strained
            .map(|(i, value)| modes.shapes[(unknown, i)].powi(2) / value)
            .sum();
        if residual[(k, k)] <= NOTHING * kept {
            residual.row_mut(k).fill(0.0);
            residual.column_mut(k).fill(0.0);
        }
    }
    let mut reduced = Reduced {
        values: modes.values.clone(),
        shapes: modes.shapes.clone(),
        residual,
    };
    if with_mass {
        reduced = with_residual_modes(pencil, reduced, &made);
    }
    modes.counted(&ordering)?;
    Ok(reduced)
}

/// The residual shapes as modes: they are orthogonal to the others already.
fn with_residual_modes(pencil: &Pencil, mut reduced: Reduced, made: &DMatrix<f64>) -> Reduced {
    let flexible: Vec<usize> = (0..made.ncols())
        .filter(|&k| reduced.residual[(k, k)] > 0.0)
        .collect();
    let scale = |k: usize| reduced.residual[(k, k)].sqrt();
    let shapes: Vec<_> = flexible
        .iter()
        .map(|&k| made.column(k) / scale(k))
        .collect();
    reduced.residual.fill(0.0);
    if shapes.is_empty() {
        return reduced;
    }
    let shapes = DMatrix::from_columns(&shapes);
    let strain = projected(pencil, &pencil.stiffness, &shapes);
    let mass = projected(pencil, &pencil.mass, &shapes);
    // Whitened by the strain, which is 1 on the diagonal; what is without mass has no mode, and is left out as such.
    let eigen = SymmetricEigen::new(strain);
    let kept: Vec<usize> = (0..flexible.len())
        .filter(|&k| eigen.eigenvalues[k] > NOTHING)
        .collect();
    let white: Vec<_> = kept
        .iter()
        .map(|&k| eigen.eigenvectors.column(k) / eigen.eigenvalues[k].sqrt())
        .collect();
    let white = DMatrix::from_columns(&white);
    let eigen = SymmetricEigen::new(white.tr_mul(&(mass * &white)));
    let mut order: Vec<usize> = (0..kept.len())
        .filter(|&k| eigen.eigenvalues[k] > 0.0)
        .collect();
    order.sort_by(|&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]));
    let shapes = shapes * white;
    for k in order {
        let compliance = eigen.eigenvalues[k];
        let shape = &shapes * eigen.eigenvectors.column(k) / compliance.sqrt();
        let next = reduced.shapes.ncols();
        reduced.values.push(1.0 / compliance);
        reduced.shapes = reduced.shapes.insert_column(next, 0.0);
        reduced.shapes.set_column(next, &shape);
    }
    reduced
}

fn craig_bampton(pencil: &Pencil, at: &[usize], wanted: usize) -> Result<Reduced, ReduceError> {
    let (inside, free) = pencil.without(at);
    let held = held(pencil, &inside, &free, at, wanted)?;
    let stiffness = projected(pencil, &pencil.stiffness, &held);
    let mass = projected(pencil, &pencil.mass, &held);
    let Some(factor) = Cholesky::new(mass) else {
        return Err(ReduceError::Indefinite {
            matrix: "mass",
            negative: 1,
        });
    };
    let lower = factor.l();
    let singular = || ReduceError::Indefinite {
        matrix: "mass",
        negative: 1,
    };
    let half = lower
        .solve_lower_triangular(&stiffness)
        .ok_or_else(singular)?;
    let white = lower
        .solve_lower_triangular(&half.transpose())
        .ok_or_else(singular)?;
    let eigen = SymmetricEigen::new((&white + white.transpose()) / 2.0);
    let mut order: Vec<usize> = (0..eigen.eigenvalues.len()).collect();
    order.sort_by(|&a, &b| eigen.eigenvalues[a].total_cmp(&eigen.eigenvalues[b]));
    let vectors: Vec<_> = order
        .iter()
        .map(|&k| eigen.eigenvectors.column(k))
        .collect();
    let vectors = lower
        .transpose()
        .solve_upper_triangular(&DMatrix::from_columns(&vectors));
    let shapes = held * vectors.ok_or_else(singular)?;
    let magnitudes = pencil.magnitudes(&shapes);
    let values = order.iter().zip(magnitudes);
    let values = values.map(|(&k, magnitude)| match eigen.eigenvalues[k] {
        value if value > 1e3 * f64::EPSILON * magnitude => value,
        _ => 0.0,
    });
    Ok(Reduced {
        values: values.collect(),
        shapes,
        residual: DMatrix::zeros(at.len(), at.len()),
    })
}

/// Modes with the points held, and the static shapes of unit displacements of each.
fn held(
    pencil: &Pencil,
    inside: &Pencil,
    free: &[usize],
    at: &[usize],
    wanted: usize,
) -> Result<DMatrix<f64>, ReduceError> {
    let ordering = Ordering::of(inside)?;
    let modes = modes(inside, &ordering, wanted)?;
    if modes.values.contains(&0.0) {
        return Err(ReduceError::StillLoose);
    }
    let mut unit = DMatrix::zeros(pencil.unknowns(), at.len());
    for (k, &unknown) in at.iter().enumerate() {
        unit[(unknown, k)] = 1.0;
    }
    let loads = pencil
        .times(&pencil.stiffness, unit.as_view())
        .select_rows(free);
    let made = modes.factor.solve(-loads)?;
    let mut shapes = DMatrix::zeros(pencil.unknowns(), wanted + at.len());
    for (row, &unknown) in free.iter().enumerate() {
        shapes
            .view_mut((unknown, 0), (1, wanted))
            .copy_from(&modes.shapes.row(row));
        shapes
            .view_mut((unknown, wanted), (1, at.len()))
            .copy_from(&made.row(row));
    }
    for (k, &unknown) in at.iter().enumerate() {
        shapes[(unknown, wanted + k)] = 1.0;
    }
    modes.counted(&ordering)?;
    Ok(shapes)
}

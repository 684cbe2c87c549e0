//! What the modes that are left out give way at the points.

use nalgebra::DMatrix;

use super::error::ReduceError;
use super::modes::Modes;
use super::pencil::Pencil;

/// What is left of the loads when their displacements are known.
const BALANCED: f64 = 1e-13;
/// Most rounds of refinement.
const ROUNDS: usize = 200;

/// The static displacements under unit loads at these unknowns that the modes do not make.
///
/// The modes are taken out of the loads first, so that nothing cancels and a structure that is not held can be loaded.
pub(super) fn displacements(
    pencil: &Pencil,
    modes: &Modes<'_>,
    at: &[usize],
) -> Result<DMatrix<f64>, ReduceError> {
    let heavy = pencil.times(&pencil.mass, modes.shapes.as_view());
    let mut loads = DMatrix::zeros(pencil.unknowns(), at.len());
    for (k, &unknown) in at.iter().enumerate() {
        loads[(unknown, k)] = 1.0;
    }
    let without = |loads: DMatrix<f64>| {
        let share = modes.shapes.tr_mul(&loads);
        loads - &heavy * share
    };
    loads = without(loads);
    let bound = BALANCED * loads.norm();
    let mut made = DMatrix::zeros(pencil.unknowns(), at.len());
    let mut last = f64::INFINITY;
    let mut left = loads.clone();
    for _ in 0..ROUNDS {
        let step = modes.factor.solve(left)?;
        made += &step;
        left = without(&loads - pencil.times(&pencil.stiffness, made.as_view()));
        let size = left.norm();
        if size <= bound || size >= last {
            break;
        }
        last = size;
    }
    let share = heavy.tr_mul(&made);
    Ok(made - &modes.shapes * share)
}

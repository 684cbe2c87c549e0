//! The lowest modes of a structure, none missing.

use nalgebra::DMatrix;

use super::error::ReduceError;
use super::factor::{Factor, Ordering};
use super::krylov::{Pairs, lowest};
use super::pencil::Pencil;

/// A stiffness whose smallest pivot is smaller than this against its diagonal may let the structure move as a whole.
const FIRM: f64 = 1e-13;
/// The first shift of such a structure, against its highest eigenvalue.
const SOFT: f64 = 1e-9;
/// Eigenvalues are zero below so many times the rounding of their strain energy.
const ROUNDING: f64 = 1e3 * f64::EPSILON;
/// Eigenvalues nearer than this are one, where they are counted.
const APART: f64 = 1e-6;
/// Modes beyond those that are wanted, so that there is a gap behind which to count.
const SPARE: usize = 4;

/// The lowest modes, and what they were found with.
pub(super) struct Modes<'a> {
    /// Eigenvalues; those of rigid motions are exactly 0.
    pub(super) values: Vec<f64>,
    /// Shapes of modal mass 1.
    pub(super) shapes: DMatrix<f64>,
    pub(super) factor: Factor<'a>,
    /// An eigenvalue that none has, and how many modes were found below it.
    gap: Option<(f64, usize)>,
}

/// The `wanted` lowest modes.
pub(super) fn modes<'a>(
    pencil: &Pencil,
    ordering: &'a Ordering<'_>,
    wanted: usize,
) -> Result<Modes<'a>, ReduceError> {
    check_mass(pencil, ordering)?;
    let (shift, mut factor) = below_all(pencil, ordering)?;
    let mut found = lowest(pencil, &factor, shift, wanted + SPARE)?;
    settle(pencil, &mut found)?;
    if let Some(shift) = nearer(shift, &found) {
        drop(factor);
        factor = ordering.shifted(shift)?;
        found = lowest(pencil, &factor, shift, wanted + SPARE)?;
        settle(pencil, &mut found)?;
    }
    let there = found.values.len();
    if there < wanted {
        return Err(ReduceError::TooMany { wanted, there });
    }
    Ok(Modes {
        values: found.values[..wanted].to_vec(),
        shapes: found.shapes.columns(0, wanted).into_owned(),
        factor,
        gap: gap(&found),
    })
}

impl Modes<'_> {
    /// Counts the modes by Sylvester's law of inertia; the factors are given back first, for two would be twice the
    /// memory.
    ///
    /// # Errors
    /// There are others.
    pub(super) fn counted(self, ordering: &Ordering<'_>) -> Result<(), ReduceError> {
        drop(self.factor);
        let Some((below, found)) = self.gap else {
            return Ok(());
        };
        let there = ordering.shifted(below)?.negative();
        let frequency = below.sqrt();
        match there == found {
            true => Ok(()),
            false => Err(ReduceError::Missed {
                found,
                there,
                frequency,
            }),
        }
    }
}

/// That no motion has negative mass.
fn check_mass(pencil: &Pencil, ordering: &Ordering<'_>) -> Result<(), ReduceError> {
    let diagonal = |values: &[f64]| -> Vec<f64> {
        (0..pencil.unknowns())
            .map(|i| values[pencil.columns[i]])
            .collect()
    };
    let masses = diagonal(&pencil.mass);
    let indefinite = |negative| {
        Err(ReduceError::Indefinite {
            matrix: "mass",
            negative,
        })
    };
    let negative = masses.iter().filter(|&&mass| mass < 0.0).count();
    if negative > 0 {
        return indefinite(negative);
    }
    if pencil
        .entries()
        .all(|(at, row, column)| row == column || pencil.mass[at] == 0.0)
    {
        return Ok(());
    }
    // Unknowns without mass are as good as those with one.
    let lifted: Vec<f64> = (pencil.entries())
        .map(|(at, row, column)| match masses[column] {
            _ if row != column => pencil.mass[at],
            0.0 => 1.0,
            mass => mass * (1.0 + SOFT),
        })
        .collect();
    match ordering.factorise(&lifted)?.negative() {
        0 => Ok(()),
        negative => indefinite(negative),
    }
}

/// A shift below all eigenvalues, and the factors there.
fn below_all<'a>(
    pencil: &Pencil,
    ordering: &'a Ordering<'_>,
) -> Result<(f64, Factor<'a>), ReduceError> {
    match ordering.shifted(0.0) {
        Ok(factor) if firm(pencil, &factor) => return Ok((0.0, factor)),
        Ok(_) | Err(ReduceError::Singular { .. }) => {}
        Err(error) => return Err(error),
    }
    let sum = |values: &[f64]| -> f64 {
        (0..pencil.unknowns())
            .map(|i| values[pencil.columns[i]].abs())
            .sum()
    };
    let shift = -SOFT * sum(&pencil.stiffness) / sum(&pencil.mass);
    let factor = ordering.shifted(shift)?;
    match factor.negative() {
        0 => Ok((shift, factor)),
        negative => Err(ReduceError::Indefinite {
            matrix: "stiffness",
            negative,
        }),
    }
}

fn firm(pencil: &Pencil, factor: &Factor<'_>) -> bool {
    let most = (0..pencil.unknowns()).map(|i| pencil.stiffness[pencil.columns[i]]);
    let most = most.fold(0.0, f64::max);
    factor.pivots().iter().all(|&pivot| pivot > FIRM * most)
}

/// Sets eigenvalues to zero that are no more than rounding.
fn settle(pencil: &Pencil, found: &mut Pairs) -> Result<(), ReduceError> {
    let magnitudes = pencil.magnitudes(&found.shapes);
    let mut negative = 0;
    for (value, magnitude) in found.values.iter_mut().zip(magnitudes) {
        if !value.is_finite() {
            return Err(ReduceError::OutOfReach(*value));
        }
        if value.abs() <= ROUNDING * magnitude {
            *value = 0.0;
        }
        negative += usize::from(*value < 0.0);
    }
    match negative {
        0 => Ok(()),
        negative => Err(ReduceError::Indefinite {
            matrix: "stiffness",
            negative,
        }),
    }
}

/// A shift as far below zero as the lowest mode that strains lies above, if the first is another by far.
fn nearer(shift: f64, found: &Pairs) -> Option<f64> {
    let lowest = found.values.iter().copied().find(|&value| value > 0.0)?;
    let far = shift < 0.0 && !(1e-2..1e2).contains(&(-shift / lowest));
    far.then_some(-lowest)
}

/// The last value that lies between two modes, and how many are below it.
fn gap(found: &Pairs) -> Option<(f64, usize)> {
    let values = &found.values;
    if found.all {
        let last = values.last()?;
        return Some((last.max(f64::MIN_POSITIVE) * 2.0, values.len()));
    }
    let pairs = (1..values.len()).rev();
    let mut apart = pairs.filter(|&i| values[i] - values[i - 1] > APART * values[i]);
    apart
        .next()
        .map(|i| (f64::midpoint(values[i], values[i - 1]), i))
}

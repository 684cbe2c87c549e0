//! Eigenvalues of a matrix, each with a bound of its error.

use nalgebra::{Complex, DMatrix, DVector};

use super::balance::balanced;
use super::schur::schur;

/// The most eigenvalues next to one that are looked at as one cluster with it.
const NEIGHBOURS: usize = 4;

/// An eigenvalue.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Eigenvalue {
    /// As it was computed.
    pub(crate) value: Complex<f64>,
    /// How far a change of the matrix moves it, at most and in the first order, over the size of that change.
    pub(crate) condition: f64,
    /// How far the nearest others are, the nearest first; infinite where there is none.
    pub(crate) gaps: [f64; NEIGHBOURS],
    /// The size of the change of the matrix for which the computed eigenvalues are the exact ones.
    pub(crate) backward: f64,
    /// The size of the matrix, in units that suit it: Frobenius' norm.
    pub(crate) size: f64,
}

impl Eigenvalue {
    /// How far it may be from the true one by rounding, and by a relative error of the matrix.
    pub(crate) fn error(&self, matrix: f64) -> f64 {
        self.moved(matrix * self.size)
    }

    /// The same for a matrix with an error of this size: by that and by the backward error of the computation, which is measured.
    pub(crate) fn moved(&self, change: f64) -> f64 {
        moved(self.condition, &self.gaps, self.backward + change)
    }
}

/// How far a change of the matrix moves an eigenvalue: condition times change, if that is less than the gap to the next one.
/// Where it is more, both move as the roots of x (g − x) = ± condition · change · g, and m of them as those of a polynomial of
/// the degree m: by the m-th root of condition · change · g₁ ⋯ g₍ₘ₋₁₎ (Lidskii), doubled for the terms between.
fn moved(condition: f64, gaps: &[f64], change: f64) -> f64 {
    let first = condition * change;
    let (mut moved, mut product) = (first, first);
    for (others, gap) in (1..).zip(gaps) {
        if moved <= *gap {
            break;
        }
        product *= gap;
        moved = 2.0 * product.powf(1.0 / f64::from(others + 1));
    }
    moved.min(first)
}

/// Eigenvalues of a square matrix; none if it is not finite.
pub(crate) fn eigenvalues(matrix: &DMatrix<f64>) -> Vec<Eigenvalue> {
    if matrix.nrows() == 0 || !matrix.iter().all(|entry| entry.is_finite()) {
        return Vec::new();
    }
    let matrix = balanced(matrix);
    let Some((basis, blocks)) = schur(&matrix) else {
        return within(&matrix);
    };
    let backward = backward(&matrix, &basis, &blocks);
    let form = Triangular::of(&basis, &blocks);
    let one = |i: usize| {
        let (right, left) = form.vectors(i);
        let condition = right.norm() * left.norm();
        let (value, gaps) = (form.triangle[(i, i)], form.gaps(i));
        // Vectors of equal ones tell nothing.
        let apart = gaps[0] > least(&form.triangle);
        let known =
            |refined: &Complex<f64>| apart && (refined - value).norm() <= condition * backward;
        let refined = refined(&matrix, value, &right, &left);
        Eigenvalue {
            value: refined.filter(known).unwrap_or(value),
            condition,
            gaps,
            backward,
            size: matrix.norm(),
        }
    };
    paired((0..matrix.nrows()).map(one).collect())
}

/// Pairs conjugate to the last bit, as they are where they were computed; the first of a pair is the upper one.
fn paired(mut all: Vec<Eigenvalue>) -> Vec<Eigenvalue> {
    for i in 1..all.len() {
        if all[i].value.im < 0.0 {
            all[i].value = all[i - 1].value.conj();
        }
    }
    all
}

/// The eigenvalue as yᵀ A x / yᵀ x tells it: vectors that are wrong by rounding err here only by the square of that.
fn refined(
    matrix: &DMatrix<f64>,
    value: Complex<f64>,
    right: &DVector<Complex<f64>>,
    left: &DVector<Complex<f64>>,
) -> Option<Complex<f64>> {
    let order = matrix.nrows();
    let row = |i: usize| {
        let image: Complex<f64> = (0..order).map(|j| right[j] * matrix[(i, j)]).sum();
        left[i] * (image - value * right[i])
    };
    let missing: Complex<f64> = (0..order).map(row).sum();
    let mut found = value + missing / left.dot(right);
    if value.im == 0.0 {
        found.im = 0.0;
    }
    (found.is_finite() && (found.im > 0.0) == (value.im > 0.0)).then_some(found)
}

/// What is known of eigenvalues that were not found: no one is larger than the matrix.
fn within(matrix: &DMatrix<f64>) -> Vec<Eigenvalue> {
    let size = matrix.norm();
    let one = Eigenvalue {
        value: Complex::new(0.0, 0.0),
        condition: 1.0,
        gaps: [f64::INFINITY; NEIGHBOURS],
        backward: size,
        size,
    };
    vec![one; matrix.nrows()]
}

/// ‖A − Q T Qᵀ‖ with what measuring it may round away.
fn backward(matrix: &DMatrix<f64>, basis: &DMatrix<f64>, blocks: &DMatrix<f64>) -> f64 {
    let order = matrix.nrows();
    let missing = matrix * basis - basis * blocks;
    let skew = basis.transpose() * basis - DMatrix::identity(order, order);
    let products = (matrix.norm() + blocks.norm()) * basis.norm();
    missing.norm() + skew.norm() * blocks.norm() + order as f64 * f64::EPSILON * products
}

/// A matrix as Z T Zᴴ with a triangular T.
struct Triangular {
    triangle: DMatrix<Complex<f64>>,
    /// T with its rows and columns exchanged and in the other order: its right vectors are the left ones of T.
    turned: DMatrix<Complex<f64>>,
    basis: DMatrix<Complex<f64>>,
}

impl Triangular {
    /// From a form with blocks of two on its diagonal: each is turned by its own eigenvector.
    fn of(basis: &DMatrix<f64>, blocks: &DMatrix<f64>) -> Self {
        let order = blocks.nrows();
        let complex = |matrix: &DMatrix<f64>| matrix.map(|entry| Complex::new(entry, 0.0));
        let (mut basis, mut triangle) = (complex(basis), complex(blocks));
        for i in 1..order {
            if blocks[(i, i - 1)] != 0.0 {
                turn(&mut basis, &mut triangle, i - 1);
            }
        }
        let last = order - 1;
        let turned = DMatrix::from_fn(order, order, |i, j| triangle[(last - j, last - i)]);
        Self {
            triangle,
            turned,
            basis,
        }
    }

    /// The right and the left vector of eigenvalue i, yᵀ x = 1.
    fn vectors(&self, i: usize) -> (DVector<Complex<f64>>, DVector<Complex<f64>>) {
        let last = self.triangle.nrows() - 1;
        let right = vector(&self.triangle, i);
        let left = vector(&self.turned, last - i);
        let left = DVector::from_fn(last + 1, |j, _| left[last - j]);
        (&self.basis * right, self.basis.conjugate() * left)
    }

    /// How far the eigenvalues nearest to number i are: as far, at least, as [`vector`] takes them to be.
    fn gaps(&self, i: usize) -> [f64; NEIGHBOURS] {
        let value = self.triangle[(i, i)];
        let others = (0..self.triangle.nrows()).filter(|j| *j != i);
        let gap = |j: usize| (self.triangle[(j, j)] - value).norm();
        let mut all: Vec<f64> = others.map(|j| gap(j).max(least(&self.triangle))).collect();
        all.sort_by(f64::total_cmp);
        all.resize(NEIGHBOURS.max(all.len()), f64::INFINITY);
        [0, 1, 2, 3].map(|k| all[k])
    }
}

/// Makes the block of rows i and i + 1 triangular.
fn turn(basis: &mut DMatrix<Complex<f64>>, triangle: &mut DMatrix<Complex<f64>>, i: usize) {
    let order = triangle.nrows();
    let [[a, b], [c, d]] = [i, i + 1].map(|row| [triangle[(row, i)].re, triangle[(row, i + 1)].re]);
    let [upper, lower] = pair(a, b, c, d);
    // (λ − d, c) is an eigenvector of the block.
    let (first, second) = (upper - d, Complex::new(c, 0.0));
    let length = first.norm().hypot(c);
    let (first, second) = (first / length, second / length);
    for matrix in [basis, &mut *triangle] {
        for j in 0..order {
            let (x, y) = (matrix[(j, i)], matrix[(j, i + 1)]);
            matrix[(j, i)] = x * first + y * second;
            matrix[(j, i + 1)] = y * first.conj() - x * second.conj();
        }
    }
    for j in 0..order {
        let (x, y) = (triangle[(i, j)], triangle[(i + 1, j)]);
        triangle[(i, j)] = x * first.conj() + y * second.conj();
        triangle[(i + 1, j)] = y * first - x * second;
    }
    (triangle[(i, i)], triangle[(i + 1, i + 1)]) = (upper, lower);
    triangle[(i + 1, i)] = Complex::new(0.0, 0.0);
}

/// The eigenvalues of [a b; c d]: conjugate to the last bit where they are complex.
fn pair(a: f64, b: f64, c: f64, d: f64) -> [Complex<f64>; 2] {
    let (middle, half) = (0.5 * (a + d), 0.5 * (a - d));
    let squared = half * half + b * c;
    let root = squared.abs().sqrt();
    if squared < 0.0 {
        [root, -root].map(|im| Complex::new(middle, im))
    } else {
        [root, -root].map(|off| Complex::new(middle + off, 0.0))
    }
}

/// How far apart rounding takes equal eigenvalues of a matrix.
fn least(triangle: &DMatrix<Complex<f64>>) -> f64 {
    f64::EPSILON * triangle.norm().max(f64::MIN_POSITIVE)
}

/// The right vector of eigenvalue i of a triangular matrix, its entry i being 1.
fn vector(triangle: &DMatrix<Complex<f64>>, i: usize) -> DVector<Complex<f64>> {
    let value = triangle[(i, i)];
    let least = least(triangle);
    let mut found = DVector::zeros(triangle.nrows());
    found[i] = Complex::new(1.0, 0.0);
    for row in (0..i).rev() {
        let sum: Complex<f64> = (row + 1..=i).map(|j| triangle[(row, j)] * found[j]).sum();
        let gap = value - triangle[(row, row)];
        // Equal eigenvalues are as far apart as rounding may take them.
        let gap = if gap.norm() < least {
            Complex::new(least, 0.0)
        } else {
            gap
        };
        found[row] = sum / gap;
    }
    found
}

#[cfg(test)]
mod tests;

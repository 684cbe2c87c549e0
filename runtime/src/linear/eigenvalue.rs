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
        let error = moved(condition, &gaps, backward);
        let refined = refined(&matrix, value, &right, &left);
        Eigenvalue {
            value: refined
                .filter(|refined| (refined - value).norm() <= error)
                .unwrap_or(value),
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
mod tests {
    use super::*;

    #[test]
    fn a_normal_matrix_has_conditions_of_one_and_a_defective_one_of_a_root_of_rounding() {
        let turn = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -1.0, 0.0]);
        for found in eigenvalues(&turn) {
            assert!((found.condition - 1.0).abs() < 1e-12, "{found:?}");
            assert!(found.error(0.0) < 1e-13, "{found:?}");
        }
        // λ² = −1 twice, with one vector only.
        let rows = [
            0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, -1.0, 1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0,
        ];
        for found in eigenvalues(&DMatrix::from_row_slice(4, 4, &rows)) {
            let off = (found.value.re).hypot(found.value.im.abs() - 1.0);
            assert!(off <= found.error(0.0), "{off:e}: {found:?}");
            assert!(found.error(0.0) < 1e-5, "{found:?}");
        }
    }

    #[test]
    fn equal_eigenvalues_with_one_vector_are_known_to_a_root_of_rounding() {
        // (λ + 1)² exactly, as of critical damping; (λ − 2)³; (λ + 1)⁴ turned, so that rounding parts them.
        let chain = |order: usize, value: f64| {
            DMatrix::from_fn(order, order, |i, j| match () {
                () if i == j => value,
                () if j == i + 1 => 1.0,
                () => 0.0,
            })
        };
        let turn = DMatrix::from_fn(4, 4, |i, j| ((i * j + i + 2 * j) as f64).sin());
        let turn = turn.qr().q();
        let damped = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -1.0, -2.0]);
        let turned = turn.transpose() * chain(4, -1.0) * &turn;
        for (matrix, value, most) in [
            (damped, -1.0, 1e-6),
            (chain(3, 2.0), 2.0, 1e-4),
            (turned, -1.0, 1e-2),
        ] {
            for found in eigenvalues(&matrix) {
                let off = (found.value - Complex::new(value, 0.0)).norm();
                let error = found.error(f64::EPSILON);
                assert!(off <= error && error < most, "{off:e}: {found:?}");
            }
        }
    }

    #[test]
    fn eigenvalues_that_lie_symmetrically_about_zero_are_found() {
        // Two masses without damping that flutter: λ⁴ + 31 λ² + 220 − c d = 0.
        for step in 0..200 {
            let product = -20.25 - 0.1 * f64::from(step + 1);
            let [first, second] = [2.5, product / 2.5];
            let rows = [
                0.0, 1.0, 0.0, 0.0, -11.0, 0.0, -second, 0.0, 0.0, 0.0, 0.0, 1.0, -first, 0.0,
                -20.0, 0.0,
            ];
            let found = eigenvalues(&DMatrix::from_row_slice(4, 4, &rows));
            let square = Complex::new(-15.5, (-20.25 - product).sqrt());
            for one in found {
                let off =
                    [square, square.conj()].map(|square| (one.value * one.value - square).norm());
                let most = 2.1 * one.value.norm() * one.error(f64::EPSILON);
                assert!(off[0].min(off[1]) <= most, "{product}: {one:?}");
                assert!(one.error(f64::EPSILON) < 1e-11, "{one:?}");
            }
        }
    }

    #[test]
    fn eigenvalues_that_are_not_found_lie_within_the_size_of_the_matrix() {
        let turn = DMatrix::from_row_slice(2, 2, &[0.0, 3.0, -4.0, 0.0]);
        let found = within(&turn);
        assert_eq!(found.len(), 2);
        assert!(found.iter().all(|one| one.error(0.0) >= 12.0_f64.sqrt()));
    }

    #[test]
    fn errors_lie_below_their_bounds_whatever_the_units() {
        // Companion matrices of polynomials whose roots are known, in units from 1e-6 to 1e6.
        for (roots, unit) in [([-1.0, -2.0, -3.0], 1e6), ([-1.0, 1e-3, 40.0], 1e-6)] {
            let [a, b, c]: [f64; 3] = roots;
            let last = [a * b * c, -(a * b + b * c + c * a), a + b + c];
            let rows = [
                0.0,
                unit,
                0.0,
                0.0,
                0.0,
                1.0 / unit,
                last[0],
                last[1] * unit,
                last[2],
            ];
            for found in eigenvalues(&DMatrix::from_row_slice(3, 3, &rows)) {
                let off = roots.map(|root| (found.value - root).norm());
                let off = off.into_iter().fold(f64::INFINITY, f64::min);
                assert!(off <= found.error(f64::EPSILON), "{off:e}: {found:?}");
                assert!(found.error(f64::EPSILON) < 1e-10, "{found:?}");
            }
        }
    }

    #[test]
    fn real_and_complex_eigenvalues_stand_beside_each_other() {
        let rows = [
            0.1, -2.0, 0.3, 1.0, 2.0, 0.1, 0.5, 0.0, 0.0, 0.0, 1.0, 0.3, 0.0, 0.0, 0.0, -3.0,
        ];
        let mut found: Vec<_> = eigenvalues(&DMatrix::from_row_slice(4, 4, &rows));
        found.sort_by(|a, b| {
            (a.value.re, a.value.im)
                .partial_cmp(&(b.value.re, b.value.im))
                .unwrap()
        });
        let expected = [(-3.0, 0.0), (0.1, -2.0), (0.1, 2.0), (1.0, 0.0)];
        for (found, (re, im)) in found.iter().zip(expected) {
            assert!((found.value - Complex::new(re, im)).norm() <= found.error(f64::EPSILON));
        }
    }
}

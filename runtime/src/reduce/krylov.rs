//! The modes nearest to a shift: Lanczos' method in blocks, each vector made orthogonal to all before it.
//!
//! See Grimes, Lewis and Simon, *A shifted block Lanczos algorithm*, SIAM J. Matrix Anal. Appl. 15 (1994) 228-272.

use nalgebra::{DMatrix, DVector, SymmetricEigen};

use super::error::ReduceError;
use super::factor::Factor;
use super::pencil::Pencil;

/// Vectors of a block: modes with the same frequency up to this number are found together.
const BLOCK: usize = 6;
/// How far a Ritz vector may be from a mode, against its own value.
const CONVERGED: f64 = 1e-11;
/// The same against the largest value, which rounding is measured by.
const ROUNDING: f64 = 1e-15;
/// An eigenvalue of (K - σ M)⁻¹ M that is zero against the largest: a motion without mass.
const MASSLESS: f64 = 1e-13;
/// What is left of a vector in a space that holds it.
const DEPENDENT: f64 = 1e-11;

/// Eigenvalues with their modes, ascending, of modal mass 1.
pub(super) struct Pairs {
    pub(super) values: Vec<f64>,
    pub(super) shapes: DMatrix<f64>,
    /// Whether there are no others.
    pub(super) all: bool,
}

/// A growing space, with its projection of (K - σ M)⁻¹ M.
struct Space<'a> {
    pencil: &'a Pencil,
    basis: DMatrix<f64>,
    heavy: DMatrix<f64>,
    projected: DMatrix<f64>,
    /// Vectors whose image is known.
    known: usize,
    used: usize,
}

/// The `wanted` lowest eigenvalues above a shift that lies below all of them.
pub(super) fn lowest(
    pencil: &Pencil,
    factor: &Factor<'_>,
    shift: f64,
    wanted: usize,
) -> Result<Pairs, ReduceError> {
    let mut space = Space::new(pencil, (4 * wanted + 20 * BLOCK).min(pencil.unknowns()));
    let start = pencil.times(&pencil.mass, noise(pencil.unknowns()).as_view());
    space.append(factor.solve(start)?);
    loop {
        let before = space.known;
        let image = factor.solve(space.heavy.columns_range(before..space.used).into_owned())?;
        let coupling = space.absorb(image);
        let found = space.ritz(&coupling, wanted);
        let exhausted = space.known == space.used;
        let there = found.with_mass();
        if found.converged >= wanted.min(there) && (exhausted || there >= wanted) {
            let pairs = space.pairs(&found, shift, wanted.min(there));
            return Ok(Pairs {
                all: exhausted && there <= wanted,
                ..pairs
            });
        }
        let full = space.used + BLOCK > space.room() && space.room() < pencil.unknowns();
        if exhausted || full {
            let (converged, dimension) = (found.converged, space.known);
            return Err(ReduceError::NotConverged {
                converged,
                wanted,
                dimension,
            });
        }
    }
}

/// Ritz values, descending, with their vectors in the space.
struct Ritz {
    values: Vec<f64>,
    vectors: DMatrix<f64>,
    converged: usize,
}

impl Ritz {
    /// How many are more than rounding.
    fn with_mass(&self) -> usize {
        let most = self.values.first().copied().unwrap_or(0.0);
        let real = self
            .values
            .iter()
            .take_while(|&&value| value > MASSLESS * most);
        real.count()
    }
}

impl<'a> Space<'a> {
    fn new(pencil: &'a Pencil, room: usize) -> Self {
        let rows = pencil.unknowns();
        Self {
            pencil,
            basis: DMatrix::zeros(rows, room),
            heavy: DMatrix::zeros(rows, room),
            projected: DMatrix::zeros(room, room),
            known: 0,
            used: 0,
        }
    }

    fn room(&self) -> usize {
        self.basis.ncols()
    }

    /// Takes the parts of these vectors that are new.
    fn append(&mut self, vectors: DMatrix<f64>) {
        for vector in vectors.column_iter() {
            if self.used == self.room() {
                return;
            }
            let mut vector = vector.into_owned();
            let before = self.norm(&vector);
            self.purge(&mut vector);
            self.purge(&mut vector);
            let heavy = self.pencil.times(&self.pencil.mass, vector.as_view());
            let norm = vector.dot(&heavy.column(0)).max(0.0).sqrt();
            if norm > DEPENDENT * before && norm.is_finite() {
                self.basis.set_column(self.used, &(vector / norm));
                self.heavy.set_column(self.used, &(heavy.column(0) / norm));
                self.used += 1;
            }
        }
    }

    fn norm(&self, vector: &DVector<f64>) -> f64 {
        let heavy = self.pencil.times(&self.pencil.mass, vector.as_view());
        vector.dot(&heavy.column(0)).max(0.0).sqrt()
    }

    fn purge(&self, vector: &mut DVector<f64>) {
        let share = self.heavy.columns(0, self.used).tr_mul(vector);
        *vector -= self.basis.columns(0, self.used) * share;
    }

    /// Notes the images of the vectors added last, and adds what is new in them; how these couple to the images.
    fn absorb(&mut self, image: DMatrix<f64>) -> DMatrix<f64> {
        let last = self.known..self.used;
        let share = self.heavy.columns(0, self.used).tr_mul(&image);
        for (k, column) in last.clone().enumerate() {
            for row in 0..=column {
                let value = match row < last.start {
                    true => share[(row, k)],
                    false => (share[(row, k)] + share[(column, row - last.start)]) / 2.0,
                };
                self.projected[(row, column)] = value;
                self.projected[(column, row)] = value;
            }
        }
        self.known = self.used;
        let residue = &image - self.basis.columns(0, self.used) * &share;
        self.append(residue);
        self.heavy
            .columns(self.known, self.used - self.known)
            .tr_mul(&image)
    }

    fn ritz(&self, coupling: &DMatrix<f64>, wanted: usize) -> Ritz {
        let eigen = SymmetricEigen::new(
            self.projected
                .view((0, 0), (self.known, self.known))
                .into_owned(),
        );
        let mut order: Vec<usize> = (0..self.known).collect();
        order.sort_by(|&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]));
        let vectors = DMatrix::from_columns(
            &order
                .iter()
                .map(|&k| eigen.eigenvectors.column(k))
                .collect::<Vec<_>>(),
        );
        let values: Vec<f64> = order.iter().map(|&k| eigen.eigenvalues[k]).collect();
        let last = self.known - coupling.ncols();
        let most = values[0].abs();
        let converged = |&k: &usize| {
            let residual = (coupling * vectors.view((last, k), (coupling.ncols(), 1))).norm();
            residual <= CONVERGED * values[k].abs() + ROUNDING * most
        };
        let converged = (0..wanted.min(self.known)).take_while(converged).count();
        Ritz {
            values,
            vectors,
            converged,
        }
    }

    fn pairs(&self, ritz: &Ritz, shift: f64, count: usize) -> Pairs {
        Pairs {
            values: ritz.values[..count]
                .iter()
                .map(|value| shift + 1.0 / value)
                .collect(),
            shapes: self.basis.columns(0, self.known) * ritz.vectors.columns(0, count),
            all: false,
        }
    }
}

/// A start in which no mode is missing: the same every time, and of no symmetry.
fn noise(rows: usize) -> DMatrix<f64> {
    let mut seed = 0x9e37_79b9_7f4a_7c15_u64;
    DMatrix::from_fn(rows, BLOCK, |_, _| {
        // Steele, Lea and Flood's SplitMix64.
        seed = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = (seed ^ (seed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (bits ^ (bits >> 31)) as f64 / u64::MAX as f64 - 0.5
    })
}

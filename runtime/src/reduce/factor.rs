//! K - σ M = L D Lᵀ, by the library faer.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::ldlt::factor::LdltRegularization;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::supernodal::SupernodalLdltRef;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LdltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Side};
use nalgebra::DMatrix;

use super::error::ReduceError;
use super::pencil::Pencil;

/// What all shifts of a pencil share: the order of elimination.
pub(super) struct Ordering<'a> {
    pencil: &'a Pencil,
    symbolic: SymbolicCholesky<usize>,
}

/// A factorised matrix on the pattern of a pencil.
pub(super) struct Factor<'a> {
    symbolic: &'a SymbolicCholesky<usize>,
    values: Vec<f64>,
}

impl<'a> Ordering<'a> {
    /// # Errors
    /// There is not enough memory.
    pub(super) fn of(pencil: &'a Pencil) -> Result<Self, ReduceError> {
        let parameters = CholeskySymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
            ..CholeskySymbolicParams::default()
        };
        let pattern = pattern(pencil);
        let symbolic =
            factorize_symbolic_cholesky(pattern, Side::Lower, SymmetricOrdering::Amd, parameters)
                .map_err(|_| ReduceError::Memory)?;
        Ok(Self { pencil, symbolic })
    }

    /// Factorises `K - shift M`.
    ///
    /// # Errors
    /// It is singular.
    pub(super) fn shifted(&self, shift: f64) -> Result<Factor<'_>, ReduceError> {
        let pairs = self.pencil.stiffness.iter().zip(&self.pencil.mass);
        let values: Vec<f64> = pairs.map(|(k, m)| k - shift * m).collect();
        self.factorise(&values)
    }

    /// Factorises these values on the pattern.
    ///
    /// # Errors
    /// The matrix is singular.
    pub(super) fn factorise(&self, values: &[f64]) -> Result<Factor<'_>, ReduceError> {
        let symbolic = &self.symbolic;
        let mut factor = vec![0.0; symbolic.len_val()];
        let scratch = symbolic.factorize_numeric_ldlt_scratch::<f64>(Par::Seq, Default::default());
        let mut buffer = MemBuffer::try_new(scratch).map_err(|_| ReduceError::Memory)?;
        let done = symbolic.factorize_numeric_ldlt(
            &mut factor,
            SparseColMatRef::new(pattern(self.pencil), values),
            Side::Lower,
            LdltRegularization::default(),
            Par::Seq,
            MemStack::new(&mut buffer),
            Default::default(),
        );
        match done {
            Err(faer::linalg::cholesky::ldlt::factor::LdltError::ZeroPivot { index }) => {
                Err(ReduceError::Singular { unknown: index + 1 })
            }
            Ok(_) => Ok(Factor {
                symbolic,
                values: factor,
            }),
        }
    }
}

fn pattern(pencil: &Pencil) -> SymbolicSparseColMatRef<'_, usize> {
    let unknowns = pencil.unknowns();
    SymbolicSparseColMatRef::new_checked(unknowns, unknowns, &pencil.columns, None, &pencil.rows)
}

impl Factor<'_> {
    /// The pivots, in the order of elimination.
    pub(super) fn pivots(&self) -> Vec<f64> {
        let mut pivots = Vec::with_capacity(self.symbolic.nrows());
        if let SymbolicCholeskyRaw::Supernodal(raw) = self.symbolic.raw() {
            let factor = SupernodalLdltRef::new(raw, &self.values);
            for node in 0..raw.n_supernodes() {
                let block = factor.supernode(node).val();
                pivots.extend((0..block.ncols()).map(|i| block[(i, i)]));
            }
        }
        pivots
    }

    /// How many eigenvalues are negative, by Sylvester's law of inertia.
    pub(super) fn negative(&self) -> usize {
        // A pivot that is not a number has no sign, and shall not pass for a positive one.
        let positive = self.pivots().iter().filter(|&&pivot| pivot > 0.0).count();
        self.symbolic.nrows() - positive
    }

    /// Solves for each column.
    pub(super) fn solve(&self, mut loads: DMatrix<f64>) -> Result<DMatrix<f64>, ReduceError> {
        let (rows, columns) = loads.shape();
        let scratch = self
            .symbolic
            .solve_in_place_scratch::<f64>(columns, Par::Seq);
        let mut buffer = MemBuffer::try_new(scratch).map_err(|_| ReduceError::Memory)?;
        let right = MatMut::from_column_major_slice_mut(loads.as_mut_slice(), rows, columns);
        LdltRef::new(self.symbolic, &self.values).solve_in_place_with_conj(
            Conj::No,
            right,
            Par::Seq,
            MemStack::new(&mut buffer),
        );
        Ok(loads)
    }
}

//! A Jacobian by few directional derivatives: states that no equation reads together share one.

use num_dual::Dual64;

use crate::field::Linear;
use crate::model::Model;
use crate::scalar::mapped;

/// The states sorted into groups, after Curtis, Powell and Reid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Columns<const N: usize> {
    /// Ones for the states of each group, zeros elsewhere; the first `groups` rows count.
    seeds: [[f64; N]; N],
    groups: usize,
    reads: [[f64; N]; N],
    kinematic: [Option<usize>; N],
    design: bool,
}

impl<const N: usize> Columns<N> {
    /// Groups by the model's sparsity; kinematic equations need no derivative and join no conflict.
    pub(super) fn of<M: Model<N>>(design: bool) -> Self {
        let mut columns = Self {
            seeds: [[0.0; N]; N],
            groups: 0,
            reads: mapped(&M::SPARSITY, |row| mapped(&row, f64::from)),
            kinematic: M::KINEMATIC,
            design,
        };
        // The rows that read a state of each group.
        let mut taken = [[false; N]; N];
        for state in 0..N {
            let reads = |row: &usize| columns.reads[*row][state] > 0.0;
            let readers = || {
                (0..N)
                    .filter(|row| M::KINEMATIC[*row].is_none())
                    .filter(reads)
            };
            let is_free = |taken: &[bool; N]| !readers().any(|row| taken[row]);
            let free = taken[..columns.groups].iter().position(is_free);
            let group = free.unwrap_or(columns.groups);
            readers().for_each(|row| taken[group][row] = true);
            columns.seeds[group][state] = 1.0;
            columns.groups = columns.groups.max(group + 1);
        }
        columns
    }

    /// f with its derivatives, from f along a seed and f along the design variable.
    #[inline(always)]
    pub(super) fn linearise(
        &self,
        along: impl Fn(&[f64; N]) -> [Dual64; N],
        along_design: impl Fn() -> [Dual64; N],
    ) -> Linear<N> {
        let mut linear = Linear {
            f: [0.0; N],
            jacobian: [[0.0; N]; N],
            design: [0.0; N],
        };
        for seed in self.seeds.iter().take(self.groups) {
            let field = along(seed);
            linear.f = mapped(&field, |f| f.re);
            for (row, f) in linear.jacobian.iter_mut().zip(&field) {
                for (entry, one) in row.iter_mut().zip(seed) {
                    *entry += one * f.eps;
                }
            }
        }
        // Where each state has a group of its own, the derivatives are what they are.
        if self.groups < N {
            self.part(&mut linear.jacobian);
        }
        if self.design {
            linear.design = along_design().map(|f| f.eps);
        }
        linear
    }

    /// Leaves to each state of a group the rows that read it.
    #[inline(always)]
    fn part(&self, jacobian: &mut [[f64; N]; N]) {
        for (row, reads) in jacobian.iter_mut().zip(&self.reads) {
            for (entry, read) in row.iter_mut().zip(reads) {
                *entry *= read;
            }
        }
        for (row, from) in self.kinematic.iter().enumerate() {
            if let Some(from) = *from {
                jacobian[row] = crate::scalar::filled(|j| f64::from(j == from));
            }
        }
    }
}

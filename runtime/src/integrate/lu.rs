//! LU factorisation of the small dense systems inside an implicit step: static storage, partial pivoting.

/// A factorised matrix of order up to `N · S`, stored by rows.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lu<const N: usize, const S: usize> {
    rows: [[[[f64; N]; S]; N]; S],
    swaps: [[usize; N]; S],
    order: usize,
}

impl<const N: usize, const S: usize> Lu<N, S> {
    /// The zero matrix of order `order` ≤ N · S.
    #[inline]
    pub(super) fn zero(order: usize) -> Self {
        Self {
            rows: [[[[0.0; N]; S]; N]; S],
            swaps: [[0; N]; S],
            order: order.min(N * S),
        }
    }

    /// Row `i`, to be filled in before [`factorise`](Self::factorise).
    #[inline]
    pub(super) fn row(&mut self, i: usize) -> &mut [f64] {
        let order = self.order;
        &mut self.rows.as_flattened_mut()[i].as_flattened_mut()[..order]
    }

    /// Factorises in place with partial pivoting; false if the matrix is singular or not finite.
    #[inline]
    pub(super) fn factorise(&mut self) -> bool {
        let order = self.order;
        let rows = self.rows.as_flattened_mut();
        let swaps = self.swaps.as_flattened_mut();
        for k in 0..order {
            let mut pivot = k;
            let mut largest = rows[k].as_flattened()[k].abs();
            for (i, row) in rows.iter().enumerate().take(order).skip(k + 1) {
                let size = row.as_flattened()[k].abs();
                if size > largest {
                    (pivot, largest) = (i, size);
                }
            }
            if !(largest > 0.0 && largest.is_finite()) {
                return false;
            }
            swaps[k] = pivot;
            rows.swap(k, pivot);
            let (upper, lower) = rows.split_at_mut(k + 1);
            let top = upper[k].as_flattened_mut();
            top[k] = 1.0 / top[k];
            for row in &mut lower[..order - k - 1] {
                let row = row.as_flattened_mut();
                let factor = row[k] * top[k];
                row[k] = factor;
                for j in k + 1..order {
                    row[j] -= factor * top[j];
                }
            }
        }
        true
    }

    /// Overwrites a right side with the solution.
    #[inline]
    pub(super) fn solve(&self, x: &mut [f64]) {
        let order = self.order;
        let rows = self.rows.as_flattened();
        let swaps = self.swaps.as_flattened();
        let x = &mut x[..order];
        for k in 0..order {
            x.swap(k, swaps[k]);
        }
        for i in 1..order {
            let row = rows[i].as_flattened();
            let mut sum = x[i];
            for j in 0..i {
                sum -= row[j] * x[j];
            }
            x[i] = sum;
        }
        for i in (0..order).rev() {
            let row = rows[i].as_flattened();
            let mut sum = x[i];
            for j in i + 1..order {
                sum -= row[j] * x[j];
            }
            x[i] = sum * row[i];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_with_row_exchanges() {
        let matrix = [[0.0, 2.0, 1.0], [1.0, 1.0, 1.0], [4.0, -1.0, 3.0]];
        let mut lu = Lu::<3, 1>::zero(3);
        for (i, row) in matrix.iter().enumerate() {
            lu.row(i).copy_from_slice(row);
        }
        assert!(lu.factorise());
        let mut x = [7.0, 6.0, 11.0]; // matrix · (1, 2, 3)
        lu.solve(&mut x);
        assert!(
            x.iter()
                .zip([1.0, 2.0, 3.0])
                .all(|(a, b)| (a - b).abs() < 1e-14),
            "{x:?}"
        );
    }

    #[test]
    fn a_singular_matrix_is_refused() {
        let mut lu = Lu::<2, 1>::zero(2);
        lu.row(0).copy_from_slice(&[1.0, 2.0]);
        lu.row(1).copy_from_slice(&[2.0, 4.0]);
        assert!(!lu.factorise());
    }
}

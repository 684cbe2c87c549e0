//! Which stage equations Newton solves, and which follow from ẏᵢ = yⱼ.

use std::marker::PhantomData;

use crate::field::Field;

/// Which rows Newton solves for, and which follow from ẏᵢ = yⱼ.
pub(super) struct Layout<F, const N: usize>(PhantomData<F>);

impl<F: Field<N>, const N: usize> Layout<F, N> {
    pub(super) const KINEMATIC: [Option<usize>; N] = eliminable(F::KINEMATIC);
    const SOLVED: ([usize; N], usize) = remaining(Self::KINEMATIC);

    pub(super) fn solved() -> &'static [usize] {
        let (rows, count) = const { &Self::SOLVED };
        &rows[..*count]
    }
}

/// Rows whose source is not itself eliminated.
const fn eliminable<const N: usize>(mut rows: [Option<usize>; N]) -> [Option<usize>; N] {
    let mut i = 0;
    while i < N {
        if let Some(source) = rows[i]
            && (source >= N || source == i || rows[source].is_some())
        {
            rows[i] = None;
        }
        i += 1;
    }
    rows
}

const fn remaining<const N: usize>(rows: [Option<usize>; N]) -> ([usize; N], usize) {
    let (mut solved, mut count, mut i) = ([0; N], 0, 0);
    while i < N {
        if rows[i].is_none() {
            solved[count] = i;
            count += 1;
        }
        i += 1;
    }
    (solved, count)
}

/// Pairs (eliminated row, the state it equals).
pub(super) fn kinematic<F: Field<N>, const N: usize>() -> impl Iterator<Item = (usize, usize)> {
    let rows = const { &Layout::<F, N>::KINEMATIC };
    rows.iter()
        .enumerate()
        .filter_map(|(row, source)| source.map(|source| (row, source)))
}

/// Where a state stands among the solved ones.
pub(super) fn position(solved: &[usize], state: usize) -> usize {
    solved.iter().position(|&row| row == state).unwrap_or(0)
}

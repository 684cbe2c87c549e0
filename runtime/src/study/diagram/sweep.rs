//! Values one after the other, each from the end of the one before.

use super::slice::{Cut, Slice, magnitude};
use crate::flow::Family;

/// Displacement with which a value begins, relative to the size of each state: without it, a motion at
/// rest, or one as symmetric as its start, would never leave what has lost its stability.
const NUDGE: f64 = 1e-6;

/// The slices at these values of r, in their order.
pub(super) fn sweep<F: Family<N> + Clone, const N: usize>(
    cut: &Cut<'_, F, N>,
    values: &[f64],
    done: &(dyn Fn() + Sync),
) -> Vec<Slice> {
    let mut scale = magnitude(&cut.start);
    let mut known = false;
    let mut state = cut.start;
    let mut slices = Vec::with_capacity(values.len());
    for &r in values {
        let (slice, trace) = cut.slice(r, state, &scale);
        if let Some(trace) = trace {
            let half = |j: usize| 0.5 * (trace.max[j] - trace.min[j]);
            if !known && (0..N).all(|j| half(j) > 0.0) {
                scale = std::array::from_fn(half);
                known = true;
            }
            state = std::array::from_fn(|j| {
                scale[j] = scale[j].max(half(j));
                trace.state[j] + NUDGE * scale[j]
            });
        }
        slices.push(slice);
        done();
    }
    slices
}

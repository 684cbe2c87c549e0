//! Values one after the other, each from the end of the one before.

use std::ops::ControlFlow;

use super::slice::{Cut, Slice, magnitude};
use crate::flow::Family;

/// Displacement with which a value begins, relative to the size of each state: without it, a motion at
/// rest, or one as symmetric as its start, would never leave what has lost its stability.
const NUDGE: f64 = 1e-6;

/// The slices at these values of r, in their order, until `seen` wants no more; `known` may have the one at r already.
pub(super) fn sweep<F: Family<N> + Clone, const N: usize>(
    cut: &Cut<'_, F, N>,
    values: &[f64],
    known: impl Fn(f64) -> Option<Slice>,
    seen: impl Fn(&Slice, bool) -> ControlFlow<()>,
) -> Vec<Slice> {
    let mut hand = Hand::new(cut.start);
    let mut slices = Vec::with_capacity(values.len());
    for &r in values {
        let old = known(r);
        let is_old = old.is_some();
        let slice = old.unwrap_or_else(|| cut.slice(r, hand.state, &hand.scale));
        hand.take(&slice);
        let verdict = seen(&slice, is_old);
        slices.push(slice);
        if verdict.is_break() {
            break;
        }
    }
    slices
}

/// What one value hands on to the next.
struct Hand<const N: usize> {
    /// Where it begins.
    state: [f64; N],
    /// How large its states usually are.
    scale: [f64; N],
    /// Whether a motion has shown that.
    known: bool,
}

impl<const N: usize> Hand<N> {
    fn new(start: [f64; N]) -> Self {
        Self {
            state: start,
            scale: magnitude(&start),
            known: false,
        }
    }

    /// Takes over from a slice; what has failed hands on nothing.
    fn take(&mut self, slice: &Slice) {
        let Ok(end) = <[f64; N]>::try_from(slice.end.as_slice()) else {
            return;
        };
        let half = |j: usize| 0.5 * (slice.max[j] - slice.min[j]);
        if !self.known && (0..N).all(|j| half(j) > 0.0) {
            self.scale = std::array::from_fn(half);
            self.known = true;
        }
        self.state = std::array::from_fn(|j| {
            self.scale[j] = self.scale[j].max(half(j));
            end[j] + NUDGE * self.scale[j]
        });
    }
}

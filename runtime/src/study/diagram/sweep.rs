//! Values one after the other, each from the end of the one before.

use std::ops::ControlFlow;

use super::slice::{Cut, Slice, magnitude};
use crate::motion::half_extents;

/// Displacement with which a value begins, relative to the size of each state: without it, a motion at
/// rest, or one as symmetric as its start, would never leave what has lost its stability.
const NUDGE: f64 = 1e-6;

/// The slices at these values of r, in their order, until `seen` wants no more; `known` may have the one at r already.
pub(super) fn sweep(
    cut: &Cut<'_>,
    values: &[f64],
    known: impl Fn(f64) -> Option<Slice>,
    seen: impl Fn(&Slice, bool) -> ControlFlow<()>,
) -> Vec<Slice> {
    let mut hand = Hand::new(cut.start);
    let mut slices = Vec::with_capacity(values.len());
    for &r in values {
        let old = known(r);
        let is_old = old.is_some();
        let slice = old.unwrap_or_else(|| cut.slice(r, &hand.state, &hand.scale));
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
struct Hand {
    /// Where it begins.
    state: Vec<f64>,
    /// How large its states usually are.
    scale: Vec<f64>,
    /// Whether a motion has shown that.
    known: bool,
}

impl Hand {
    fn new(start: &[f64]) -> Self {
        Self {
            state: start.to_vec(),
            scale: magnitude(start),
            known: false,
        }
    }

    /// Takes over from a slice; what has failed hands on nothing.
    fn take(&mut self, slice: &Slice) {
        if slice.end.len() != self.state.len() {
            return;
        }
        let half = half_extents(&slice.min, &slice.max, &vec![0.0; self.state.len()]);
        if !self.known && half.iter().all(|half| *half > 0.0) {
            self.scale.clone_from(&half);
            self.known = true;
        }
        for (j, end) in slice.end.iter().enumerate() {
            self.scale[j] = self.scale[j].max(half[j]);
            self.state[j] = end + NUDGE * self.scale[j];
        }
    }
}

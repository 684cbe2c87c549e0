//! Values one after the other, each from the end of the one before.

use super::slice::Slice;
use crate::motion::half_extents;

/// Displacement with which a value begins, relative to the size of each state: without it, a motion at
/// rest, or one as symmetric as its start, would never leave what has lost its stability.
const NUDGE: f64 = 1e-6;

/// What a value of a sweep begins with, and hands on to the next.
pub(super) struct Hand {
    /// Where it begins.
    state: Vec<f64>,
    /// Where the value before has ended: a wall may be beside that.
    end: Vec<f64>,
    /// Where the first one began: a wall may have moved past all of that.
    first: Vec<f64>,
    /// How large its states usually are.
    pub(super) scale: Vec<f64>,
    /// Whether a motion has shown that.
    known: bool,
}

impl Hand {
    pub(super) fn new(start: &[f64]) -> Self {
        Self {
            state: start.to_vec(),
            end: start.to_vec(),
            first: start.to_vec(),
            scale: magnitude(start),
            known: false,
        }
    }

    /// Where it begins, or, if it cannot, where it does instead.
    pub(super) fn starts(&self) -> [&[f64]; 3] {
        [&self.state, &self.end, &self.first]
    }

    /// Takes over from a slice; what has failed hands on nothing.
    pub(super) fn take(&mut self, slice: &Slice) {
        if slice.end.len() != self.state.len() {
            return;
        }
        let half = half_extents(&slice.min, &slice.max, &vec![0.0; self.state.len()]);
        if !self.known && half.iter().all(|half| *half > 0.0) {
            self.scale.clone_from(&half);
            self.known = true;
        }
        self.end.clone_from(&slice.end);
        for (j, end) in slice.end.iter().enumerate() {
            self.scale[j] = self.scale[j].max(half[j]);
            self.state[j] = end + NUDGE * self.scale[j];
        }
    }
}

/// Magnitudes as far as a start shows them.
fn magnitude(start: &[f64]) -> Vec<f64> {
    let largest = start.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let other = if largest > 0.0 { largest } else { 1.0 };
    let size = |&x: &f64| if x == 0.0 { other } else { x.abs() };
    start.iter().map(size).collect()
}

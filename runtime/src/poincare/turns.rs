//! The extrema of one state over passages that follow each other.

use crate::motion::Extremum;

/// Extrema closer than this, relative to their size, are both ends of one stretch of rest.
const ONE_REST: f64 = 1e-12;

/// Joins the extrema of passages: a rest that is divided between two passages is reported by both.
///
/// One extremum is held back until the next one tells what it was.
#[derive(Debug, Clone)]
pub(super) struct Turns {
    index: usize,
    held: Option<Extremum>,
    /// Whether the last one handed on was a maximum.
    last: Option<bool>,
}

impl Turns {
    pub(super) fn of(index: usize) -> Self {
        Self {
            index,
            held: None,
            last: None,
        }
    }

    /// Takes the next extremum in time; hands on the one before it, once that is certain.
    pub(super) fn take(&mut self, next: Extremum) -> Option<Extremum> {
        if next.index != self.index {
            return None;
        }
        let Some(held) = &self.held else {
            self.held = (self.last != Some(next.maximum)).then_some(next);
            return None;
        };
        if held.maximum == next.maximum {
            return None;
        }
        let (a, b) = (held.state[self.index], next.state[self.index]);
        if one_rest(a, b) {
            self.held = None;
            return None;
        }
        self.last = Some(held.maximum);
        self.held.replace(next)
    }

    /// The one that was held back, if the motion has left it where it ends.
    pub(super) fn finish(&mut self, end: &[f64]) -> Option<Extremum> {
        let held = self.held.take()?;
        let (a, b) = (held.state[self.index], end[self.index]);
        (!one_rest(a, b)).then_some(held)
    }
}

fn one_rest(a: f64, b: f64) -> bool {
    (a - b).abs() <= ONE_REST * a.abs().max(b.abs())
}

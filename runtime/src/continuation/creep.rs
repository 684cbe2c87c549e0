//! Steps that lead nowhere: ever tinier ones, and those on which r stands still.

use super::range::Stop;

/// Steps shorter than this, in scaled coordinates, are tiny: so many lead nowhere, unless longer ones go as far in between.
pub(super) const TINY: f64 = 1e-4;
const CREEPING: usize = 600;
/// After so many of them they may be what errors leave of longer ones: points are evaluated more sharply, if they can be.
const NOISY: usize = 60;
/// Share of r by which it stands still: so many such steps are spent on orbits that r does not tell apart, as along a canard.
pub(super) const STILL: f64 = 1e-12;
const STANDING: usize = 600;

/// How a branch has crept so far.
#[derive(Debug)]
pub(super) struct Creep {
    /// How many more tiny steps were made than longer ones have made up for.
    tiny: usize,
    /// How many may be.
    patience: usize,
    /// Steps in a row on which r stood still.
    still: usize,
}

impl Creep {
    /// At the beginning of a branch.
    pub(super) fn none() -> Self {
        Self {
            tiny: 0,
            patience: NOISY,
            still: 0,
        }
    }

    /// After a step of this length.
    pub(super) fn step(&mut self, length: f64) {
        self.tiny = match length < TINY {
            true => self.tiny + 1,
            false => self.tiny.saturating_sub((length / TINY) as usize),
        };
    }

    /// After one on which r stood still, or did not.
    pub(super) fn stand(&mut self, still: bool) {
        self.still = if still { self.still + 1 } else { 0 };
    }

    /// From now on tiny steps are what they seem to be.
    pub(super) fn is_sharp(&mut self) {
        self.patience = CREEPING;
    }

    /// Why to go no further, if there is no use.
    pub(super) fn stop<E>(&self) -> Option<Stop<E>> {
        // Where r stands still, along a canard, they are what they seem to be.
        let patience = if self.still > 0 {
            CREEPING
        } else {
            self.patience
        };
        if self.tiny > patience {
            return Some(Stop::Creeping(TINY));
        }
        (self.still >= STANDING).then_some(Stop::Upright(self.still))
    }
}

//! The motion from a border once around, and how its end depends on its beginning.

use crate::motion::{Derivatives, Place};

/// The motion from the border once around, in pieces.
pub(super) struct Round {
    /// From the border to where all is calm: that place, and how it depends on where it began.
    pub(super) out: (Place, Derivatives),
    /// Back to the border, at last held in its mode.
    pub(super) back: (Place, Derivatives),
}

impl Round {
    pub(super) fn derivatives(&self) -> Derivatives {
        chain(&self.out.1, &self.back.1)
    }
}

/// The derivatives of one motion after another. The motion's own velocity is carried into itself, so that
/// with any share of the time the end moves at its velocity there.
pub(super) fn chain(first: &Derivatives, second: &Derivatives) -> Derivatives {
    Derivatives {
        state: &second.state * &first.state,
        design: &second.design + &second.state * &first.design,
        time: second.time.clone(),
        determinant: first.determinant.times(second.determinant),
        factors: Vec::new(),
        lost: first.lost.max(second.lost),
    }
}

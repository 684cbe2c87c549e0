//! A border that an orbit meets twice, the second time as its mirror image after half a period.
//!
//! Both events begin or cease at once. The motion is followed to its image only, and mirrored: x ↦ S φ(x, T/2), S being the
//! symmetry. An orbit is a fixed point of that, and its return map is that map twice.

use crate::motion::{Derivatives, Flow, Modes, Place};
use crate::shooting::symmetry::Symmetry;

/// The mirror image of a border.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Mirror {
    pub(super) symmetry: Symmetry,
    /// Modes before and after.
    pub(super) modes: [Modes; 2],
}

impl Mirror {
    /// The end of a motion to the image of a border, and how it depends on its beginning, seen in the mirror.
    pub(super) fn turned(&self, (end, along): (Place, Derivatives)) -> (Place, Derivatives) {
        let matrix = self.symmetry.matrix();
        let turned = Derivatives {
            state: &matrix * along.state,
            design: &matrix * along.design,
            time: &matrix * along.time,
            ..along
        };
        let place = Place {
            state: self.symmetry.of(&end.state),
            modes: end.modes,
        };
        (place, turned)
    }

    /// The place of the image of a border.
    pub(super) fn image(&self, flow: &dyn Flow, border: &Place) -> Place {
        Place {
            state: flow.wrapped(self.symmetry.of(&border.state)),
            modes: self.modes[1].clone(),
        }
    }
}

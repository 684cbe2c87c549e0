//! A border that an orbit meets twice, the second time as its mirror image after half a period.
//!
//! Both events begin or cease at once. The motion is followed to its image only, and mirrored: x ↦ S φ(x, T/2), S being the
//! symmetry. An orbit is a fixed point of that, and its return map is that map twice.

use crate::flow::{FlowError, Want};
use crate::motion::{Derivatives, Event, Flow, Modes, Passage, Place};
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

    /// The motion once around of an orbit on its border: from a calm start to the image, from there to the border, and back.
    ///
    /// # Errors
    /// The motion cannot be followed.
    pub(super) fn around(
        &self,
        flow: &dyn Flow,
        (start, border): (&Place, &Place),
        (calm, period): (f64, f64),
    ) -> Result<Passage, FlowError> {
        let image = Place {
            state: flow.wrapped(self.symmetry.of(&border.state)),
            modes: self.modes[1].clone(),
        };
        let mut all = flow.advance(start, (0.5 - calm) * period, Want::EXTREMA)?;
        for (place, share) in [(&image, 0.5), (border, calm)] {
            let next = flow.advance(place, share * period, Want::EXTREMA)?;
            join(&mut all, next);
        }
        Ok(all)
    }
}

/// What follows a motion becomes part of it.
fn join(all: &mut Passage, next: Passage) {
    let before = all.time;
    all.extrema.extend(next.extrema.into_iter().map(|mut one| {
        one.time += before;
        one
    }));
    all.events.extend(next.events.into_iter().map(|one| Event {
        time: before + one.time,
        ..one
    }));
    for j in 0..all.calm.low.len() {
        all.calm.low[j] = all.calm.low[j].min(next.calm.low[j]);
        all.calm.high[j] = all.calm.high[j].max(next.calm.high[j]);
    }
    all.segments.extend(next.segments);
    all.time += next.time;
    all.work += next.work;
    all.end = next.end;
}

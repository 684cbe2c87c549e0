//! Which event of an orbit is the mirror image of another one.

use super::around::Around;
use super::mirror::Mirror;

/// Share of the period within which an event is the image of another one.
const SAME: f64 = 1e-5;

impl Around<'_> {
    /// The image of the border at an event with all that belongs to it, if the orbit has one.
    pub(super) fn mirror(&self, event: usize, own: &[usize], inside: bool) -> Option<Mirror> {
        let symmetry = self.symmetry.clone()?;
        let image = &self.orbit.events[self.image(event)?];
        let [before, held] = match inside {
            true => self.inside(image)?,
            false => self.around(image)?,
        };
        let after = match own.last() {
            Some(last) => self.around(&self.orbit.events[self.image(*last)?])?[1],
            None => held,
        };
        let modes = [before.clone(), after.clone()];
        Some(Mirror { symmetry, modes })
    }

    /// The event of the same kind half a period after this one.
    pub(super) fn image(&self, event: usize) -> Option<usize> {
        let (events, period) = (&self.orbit.events, self.orbit.period);
        let here = &events[event];
        let off = |i: &usize| {
            let turns = (events[*i].time - here.time) / period - 0.5;
            (turns - turns.round()).abs()
        };
        let alike = |i: &usize| events[*i].kind.is_switch() == here.kind.is_switch();
        let nearest = (0..events.len()).filter(alike);
        let nearest = nearest.min_by(|a, b| off(a).total_cmp(&off(b)));
        nearest.filter(|i| off(i) <= SAME)
    }
}

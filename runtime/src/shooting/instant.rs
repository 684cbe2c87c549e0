//! Where a motion is as a contact switches: when that is depends on where it begins.

use nalgebra::DVector;

use crate::field::exact::Mode;
use crate::flow::FlowError;
use crate::motion::{Derivatives, Event, Flow, Modes, Passage, Place, Segment};

/// Part of a motion within which two times are one.
const SAME: f64 = 1e-12;

/// What happens at one instant of a motion.
#[derive(Debug, Clone)]
pub(super) struct Instant {
    contact: usize,
    /// The modes before.
    before: Modes,
}

impl Instant {
    /// What makes contacts switch at this time of a motion, if it is friction.
    pub(super) fn of(passage: &Passage, time: f64) -> Option<Self> {
        let near = |other: f64| (other - time).abs() <= SAME * passage.time;
        let slides = |event: &&Event| event.switches() && !event.mode.is_of_press();
        let cause = |event: &&Event| near(event.time) && slides(event) && event.rate != 0.0;
        let contact = passage.events.iter().find(cause)?.contact;
        let mut end = 0.0;
        let ends = |segment: &&Segment| {
            end += segment.duration;
            near(end)
        };
        let before = passage.segments.iter().find(ends)?.modes.clone();
        Some(Self { contact, before })
    }

    /// Makes of derivatives at a fixed time those of the state as it happens: ∂t/∂x = −g_x Φ/(g_x f) with g the speed of what
    /// slides before, or what more would be borne by what sticks.
    ///
    /// # Errors
    /// The forces are not determined there.
    pub(super) fn carry(
        &self,
        flow: &dyn Flow,
        state: &[f64],
        derivatives: &mut Derivatives,
    ) -> Result<(), FlowError> {
        let contacts = flow.contacts(&Place::known(flow, state, Some(&self.before))?)?;
        let contact = &contacts.all[self.contact];
        let (speed, force, stick) = (&contact.speed, &contact.force, &contact.stick);
        let sticks = self.before[self.contact] == Mode::Stick;
        let slope = |speed: f64, force: f64, stick: f64| match sticks {
            true => stick - force * contact.force.value.signum(),
            false => speed,
        };
        let slopes =
            (0..state.len()).map(|j| slope(speed.slopes[j], force.slopes[j], stick.slopes[j]));
        let guard = DVector::from_iterator(state.len(), slopes);
        let fall = guard.dot(&contacts.f);
        if fall == 0.0 {
            return Ok(());
        }
        let later = guard.tr_mul(&derivatives.state) / -fall;
        let by_r = guard.dot(&derivatives.design) + slope(speed.design, force.design, stick.design);
        derivatives.state += &contacts.f * later;
        derivatives.design.axpy(-by_r / fall, &contacts.f, 1.0);
        Ok(())
    }
}

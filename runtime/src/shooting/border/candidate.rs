//! Where an orbit comes near to another order of events, and how the motion around that is divided.

use super::mirror::Mirror;
use crate::bifurcation::Kind;
use crate::field::exact::Mode;
use crate::flow::{EventKind, FlowError};
use crate::motion::{Event, Flow, Modes, Place};
use crate::shooting::Orbit;

/// Share of a margin by which it differs from itself for rounding.
const SAME: f64 = 1e-9;

/// What holds at a border.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Condition {
    /// The guard of a contact falls to zero and rises again: w, or stick − |λ| of one that sticks.
    Touch,
    /// A contact comes to rest just where the force that could hold it is at its limit.
    Edge,
}

/// A border that an orbit is near to.
#[derive(Debug, Clone, PartialEq)]
pub struct Border {
    /// Number of the contact.
    pub contact: usize,
    /// What holds there.
    pub condition: Condition,
    /// Whether it is what holds a press closed that vanishes, and not its gap.
    pub(super) by_hold: bool,
    /// Whether friction drops where the contact lets go, so that a motion jumps beyond.
    pub drops: bool,
    /// Whether the event that begins or ceases there happens on the orbit from which this was read.
    pub happens: bool,
    pub(super) state: Vec<f64>,
    /// Modes before and after.
    pub(super) modes: [Modes; 2],
    /// Shares of the period up to which the motion is held in its mode, and from which on.
    pub(super) held: [f64; 2],
    /// Share of the period, between these, at which all events are as far away as may be.
    pub(super) calm: f64,
    /// Distance in time, as a share of the period.
    pub(super) away: f64,
    /// When the short stretches begin and end that belong to it and to its image, if there are any.
    pub(super) brief: Vec<[f64; 2]>,
    /// Its mirror image, if the orbit is its own after half a period.
    pub(super) mirror: Option<Mirror>,
}

impl Border {
    /// One at an event, between these modes, of which nothing else is known yet.
    pub(super) fn new(event: &Event, condition: Condition, modes: [Modes; 2]) -> Self {
        Self {
            contact: event.contact,
            condition,
            by_hold: false,
            drops: false,
            happens: event.kind.is_switch(),
            state: event.state.clone(),
            modes,
            held: [0.0; 2],
            calm: 0.0,
            away: f64::INFINITY,
            brief: Vec::new(),
            mirror: None,
        }
    }

    /// Whether a sliding contact comes to rest for a moment there.
    pub(super) fn is_graze(&self) -> bool {
        self.condition == Condition::Touch
            && self.before() != Mode::Stick
            && !self.before().is_of_press()
    }

    /// Whether contacts turn with what is grazed: then friction jumps there, hit or not.
    pub(super) fn turns(&self) -> bool {
        let [before, after] = &self.modes;
        let keeps = self.before().is_of_press() && self.before() == self.after();
        self.condition == Condition::Touch && keeps && before != after
    }

    /// Whether a gap opens there for a moment, of a press that has let go before.
    pub(super) fn is_from_inside(&self) -> bool {
        self.happens && self.before() == Mode::Parted && !self.by_hold
    }

    /// Whether a press lets go at its event or pushes again, or nearly does, by what holds it closed and not by its gap.
    pub(super) fn lets_go(&self, flow: &dyn Flow, event: &Event) -> Result<bool, FlowError> {
        Ok(match (self.before(), event.kind) {
            (_, EventKind::Nearest { margin }) => {
                let hold = flow.hold(&self.coming(&event.state), self.contact)?;
                hold.is_some_and(|[hold, _]| (hold - margin).abs() <= SAME * margin.abs())
            }
            (Mode::Closed, EventKind::Opening) => event.mode == Mode::Parted,
            (Mode::Parted, EventKind::Closing) => true,
            _ => false,
        })
    }

    /// What vanishes at a place in the mode in which the motion comes, and its rate; `None` if there is no such contact.
    pub(super) fn touch(&self, flow: &dyn Flow, at: &Place) -> Result<Option<[f64; 2]>, FlowError> {
        if self.by_hold {
            flow.hold(at, self.contact)
        } else {
            flow.touch(at, self.contact)
        }
    }

    /// Whether a stretch is short beside it on the orbit from which this was read.
    pub(super) fn is_brief(&self) -> bool {
        !self.brief.is_empty()
    }

    /// Whether what is short of it is all that the words of these orbits differ by.
    pub(super) fn parts(&self, orbit: &Orbit, other: &Orbit) -> bool {
        self.is_brief() && self.long(orbit).has_word_of(other, 1)
    }

    /// The orbit without what is short of it.
    pub(super) fn long(&self, orbit: &Orbit) -> Orbit {
        let without = |orbit: Orbit, brief: &[f64; 2]| orbit.without(*brief);
        self.brief.iter().fold(orbit.clone(), without)
    }

    /// Whether its contact does more on this orbit than to stick, but for what is short.
    pub(super) fn is_of_sliding(&self, orbit: &Orbit) -> bool {
        let long = self.long(orbit);
        let mut modes = long.segments.iter().map(|one| one.modes[self.contact]);
        modes.any(|mode| mode != Mode::Stick)
    }

    /// Share of the period after which the motion is back, or its image.
    pub(super) fn turn(&self) -> f64 {
        if self.mirror.is_some() { 0.5 } else { 1.0 }
    }

    /// The modes in which the motion comes back to it, or to its image.
    pub(super) fn arriving(&self) -> &Modes {
        let mirror = self.mirror.as_ref();
        &mirror.map_or(&self.modes, |mirror| &mirror.modes)[0]
    }

    /// The mode in which the contact comes to it.
    pub(super) fn before(&self) -> Mode {
        self.modes[0]
            .get(self.contact)
            .copied()
            .unwrap_or(Mode::Stick)
    }

    /// The mode in which it goes on.
    pub(super) fn after(&self) -> Mode {
        let own = self.modes[1].get(self.contact);
        own.copied().unwrap_or(Mode::Stick)
    }

    /// Whether it may be called so.
    #[must_use]
    pub fn may_be(&self, kind: Kind) -> bool {
        [-1.0, 1.0].iter().any(|rate| self.kind(*rate) == kind)
    }

    /// What it is called; `rate` is that of the force's way to its limit, at an edge.
    #[must_use]
    pub fn kind(&self, rate: f64) -> Kind {
        match (self.condition, self.before()) {
            (Condition::Touch, Mode::Stick) => Kind::AddingSliding,
            (Condition::Touch, mode) if mode.is_of_press() => Kind::Grazing,
            (Condition::Touch, _) => Kind::GrazingSliding,
            (Condition::Edge, _) if rate < 0.0 => Kind::CrossingSliding,
            (Condition::Edge, _) => Kind::SwitchingSliding,
        }
    }

    /// The place of a state in the modes in which the motion comes to it.
    pub(super) fn coming(&self, state: &[f64]) -> Place {
        Place {
            state: state.to_vec(),
            modes: self.modes[0].clone(),
        }
    }

    /// The place of a state in the modes in which it goes on.
    pub(super) fn going(&self, state: &[f64]) -> Place {
        Place {
            state: state.to_vec(),
            modes: self.modes[1].clone(),
        }
    }

    /// The place of a state in the modes in which the motion comes to it, but with its contact held.
    pub(super) fn stuck(&self, state: &[f64]) -> Place {
        let mut place = self.coming(state);
        place.modes[self.contact] = Mode::Stick;
        place
    }
}

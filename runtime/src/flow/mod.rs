//! Where a motion is after a time, and how that depends on where it began.

mod determinant;
mod drive;
mod error;
pub mod event;
pub mod exact;
mod extrema;
mod family;
pub mod passage;
mod reach;
pub(crate) mod saltation;
mod sensitivity;
mod smooth;
mod told;

pub use determinant::Determinant;
pub(crate) use drive::{countable, longest, standing, strobes};
pub use error::FlowError;
pub use event::EventKind;
pub use family::{ExactFamily, SmoothFamily};
pub use sensitivity::SensitivityUndefined;
pub use smooth::SmoothFlow;

use serde::{Deserialize, Serialize};

use crate::field::Work;
use crate::integrate::gauss;

/// A field, with its derivatives.
pub type Velocity<const N: usize> = passage::Velocity<[f64; N], [[f64; N]; N]>;
/// How the end of a passage depends on its beginning.
pub type Derivatives<const N: usize> = passage::Derivatives<[f64; N], [[f64; N]; N]>;
/// A factor of Φ.
pub type Factor<const N: usize> = passage::Factor<[[f64; N]; N]>;
/// A local extremum of one state.
pub type Extremum<const N: usize> = passage::Extremum<[f64; N]>;
/// A state on a motion.
pub type Sample<const N: usize> = passage::Sample<[f64; N]>;
/// A node of a quadrature over a motion.
pub type Node<const N: usize> = passage::Node<[f64; N]>;
/// Something that happened at a contact.
pub type Event<const N: usize> = passage::Event<[f64; N]>;

/// The motion of a system: smooth and exact systems are both just flows.
pub trait Flow<const N: usize> {
    /// What a place knows besides its state: nothing for a smooth system, the mode of each contact for an exact one.
    type Mode: Copy + PartialEq + std::fmt::Debug + Send + Sync;

    /// The state that is the phase of a drive, if there is one: 2π more of it is the same.
    ///
    /// It has no extrema; in their place a passage reports each time at which it begins anew, there as 0.
    const PHASE: Option<usize> = None;

    /// The place of a state: decides the modes from which the motion will continue.
    ///
    /// # Errors
    /// No mode is consistent with the state.
    fn place(&self, state: [f64; N]) -> Result<Place<N, Self::Mode>, FlowError>;

    /// How many directions of motion this mode takes away: as many multipliers of an orbit through it are exactly zero.
    fn sticking(_mode: &Self::Mode) -> usize {
        0
    }

    /// Follows the motion from `from` for the time `time` ≥ 0.
    ///
    /// # Errors
    /// Any [`FlowError`]; a result is never NaN.
    fn advance(
        &self,
        from: &Place<N, Self::Mode>,
        time: f64,
        want: Want,
    ) -> Result<Passage<N, Self::Mode>, FlowError>;

    /// f and ∂f/∂r at a place (one-sided where the motion will continue).
    ///
    /// # Errors
    /// The field is not finite there, or no mode is consistent.
    fn velocity(&self, at: &Place<N, Self::Mode>) -> Result<Velocity<N>, FlowError>;
}

/// A point of phase space from which a motion continues in one way only.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place<const N: usize, Mode> {
    /// The state.
    pub state: [f64; N],
    /// The modes of the contacts.
    pub mode: Mode,
}

/// Which local extrema of the states are reported; if any, each instant at which the phase of a drive begins anew, too.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Peaks {
    /// None.
    #[default]
    Nowhere,
    /// Such instants alone.
    Strobes,
    /// All of this state, and of any other at least those beyond all that it was before: of a state that swings fast, few.
    Extent(usize),
    /// All of every state.
    All,
}

/// What a passage shall report beyond its end.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Want {
    /// Φ, ∂φ/∂r and ∫ tr J.
    pub derivatives: bool,
    /// Extrema.
    pub extrema: Peaks,
    /// Samples of the motion, dense enough to draw.
    pub path: bool,
    /// The factors of Φ, for multipliers that would underflow in their product.
    pub factors: bool,
    /// Nodes of a quadrature over the motion, in panels no longer than this time; none if it is 0.
    pub panel: f64,
    /// A passage ends before its time, after a step, once it has so many samples; never if this is 0.
    pub samples: usize,
}

impl Want {
    /// The end alone.
    const END: Self = Self {
        derivatives: false,
        extrema: Peaks::Nowhere,
        path: false,
        factors: false,
        panel: 0.0,
        samples: 0,
    };
    /// Derivatives.
    pub const DERIVATIVES: Self = Self {
        derivatives: true,
        ..Self::END
    };
    /// Extrema.
    pub const EXTREMA: Self = Self {
        extrema: Peaks::All,
        ..Self::END
    };
    /// Where the phase of a drive begins anew.
    pub const STROBES: Self = Self {
        extrema: Peaks::Strobes,
        ..Self::END
    };
    /// What one Newton iteration of shooting asks for: both.
    pub const SHOT: Self = Self {
        extrema: Peaks::All,
        ..Self::DERIVATIVES
    };

    /// Whether it is noted where the phase of a drive begins anew.
    pub(crate) fn notes_turns(&self) -> bool {
        self.extrema != Peaks::Nowhere
    }

    /// Whether any extrema are reported.
    pub(crate) fn looks_for_extrema(&self) -> bool {
        matches!(self.extrema, Peaks::Extent(_) | Peaks::All)
    }

    /// Whether a passage with so many samples goes no further.
    pub(crate) fn suffices(&self, samples: usize) -> bool {
        self.samples > 0 && samples >= self.samples
    }
}

/// One motion from a place to another.
#[derive(Debug, Clone, PartialEq)]
pub struct Passage<const N: usize, Mode> {
    /// Where it ended.
    pub end: Place<N, Mode>,
    /// How long it took: what was asked, unless it has the samples that suffice.
    pub time: f64,
    /// How the end depends on the beginning, if that was wanted.
    pub derivatives: Option<Derivatives<N>>,
    /// Extrema of the states in the order of time, if wanted.
    pub extrema: Vec<Extremum<N>>,
    /// Stretches in constant mode, in the order of time; one for a smooth system.
    pub segments: Vec<Segment<Mode>>,
    /// What happened at the contacts, in the order of time; nothing for a smooth system.
    pub events: Vec<Event<N>>,
    /// Samples of the motion, if wanted.
    pub path: Vec<Sample<N>>,
    /// Nodes of a quadrature over the motion, if wanted: Gauss's, within each step.
    pub nodes: Vec<Node<N>>,
    /// Where the motion is calmest: a good place to begin an orbit.
    pub calm: Calm<N, Mode>,
    /// How far rounding of what vanished at its events may have put the state off, in its usual magnitudes: the most at one of
    /// them; 0 without derivatives.
    pub rounding: f64,
    /// What it cost.
    pub work: Work,
}

/// The place between two steps of which the shorter one is longest, or the middle of a step twice as long.
///
/// Next to a short step something is about to happen, or has just happened: a start there would
/// soon fall before it or behind it as the design variable changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Calm<const N: usize, Mode> {
    /// When, from the beginning of the passage.
    pub time: f64,
    /// Length of the shorter step beside it, or of half the step around it.
    pub step: f64,
    /// Where.
    pub place: Place<N, Mode>,
    /// Least value of each state at the ends of the steps.
    pub low: [f64; N],
    /// Largest value of each state there.
    pub high: [f64; N],
    /// When and where the last step ended, and its length.
    last: (f64, f64, Place<N, Mode>),
}

impl<const N: usize, Mode: Copy> Calm<N, Mode> {
    /// Nothing known yet: the beginning itself.
    pub(crate) fn at(place: Place<N, Mode>) -> Self {
        Self {
            time: 0.0,
            step: 0.0,
            place,
            low: place.state,
            high: place.state,
            last: (0.0, 0.0, place),
        }
    }

    /// Told of the middle of a step: where steps are as long as a closed form holds, few places are between two of them.
    pub(crate) fn offer_middle(
        &mut self,
        time: f64,
        half: f64,
        place: impl FnOnce() -> Place<N, Mode>,
    ) {
        if half > self.step {
            (self.time, self.step, self.place) = (time, half, place());
        }
    }

    /// Told that a step of this length ended at this time in this place.
    pub(crate) fn offer(&mut self, time: f64, step: f64, place: Place<N, Mode>) {
        let (last_time, last_step, last_place) = self.last;
        if last_step.min(step) > self.step {
            self.time = last_time;
            self.step = last_step.min(step);
            self.place = last_place;
        }
        self.last = (time, step, place);
        for (j, value) in place.state.into_iter().enumerate() {
            self.low[j] = self.low[j].min(value);
            self.high[j] = self.high[j].max(value);
        }
    }
}

/// A stretch of a motion in constant mode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment<Mode> {
    /// The modes of the contacts during it.
    pub mode: Mode,
    /// Its duration.
    pub duration: f64,
    /// The contact whose impact began it, if one did.
    pub impact: Option<usize>,
}

/// The nodes of a step of length `length` from `time`; `probe` is the step map at a fraction of the step.
pub(crate) fn nodes<const N: usize>(
    want: Want,
    (time, length): (f64, f64),
    found: &mut Vec<Node<N>>,
    mut probe: impl FnMut(f64) -> [f64; N],
) {
    if want.panel > 0.0 {
        let panels = (length / want.panel).ceil().max(1.0) as u32;
        for (theta, weight) in gauss(panels) {
            found.push(Node {
                time: time + theta * length,
                weight: weight * length,
                state: probe(theta),
            });
        }
    }
}

//! Where a motion is after a time, and how that depends on where it began.

mod drive;
mod error;
pub mod event;
pub mod exact;
mod extrema;
mod family;
mod reach;
pub(crate) mod saltation;
mod smooth;
mod told;

pub(crate) use drive::{standing, strobes};
pub use error::{FlowError, SensitivityUndefined};
pub use event::{Event, EventKind};
pub use family::{ExactFamily, Family, SmoothFamily};
pub use smooth::SmoothFlow;

use borsh::{BorshDeserialize, BorshSerialize};

use crate::field::Work;

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

    /// How many contacts stick in this mode: as many multipliers of an orbit through it are exactly zero.
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

/// The field at a place, with its derivatives where the motion continues.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Velocity<const N: usize> {
    /// f.
    pub f: [f64; N],
    /// ∂fᵢ/∂yⱼ.
    pub jacobian: [[f64; N]; N],
    /// ∂f/∂r.
    pub design: [f64; N],
    /// How many internal states rest on their stops: their rows of the Jacobian are zero.
    pub lost: usize,
}

/// What a passage shall report beyond its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, BorshSerialize, BorshDeserialize)]
pub struct Want {
    /// Φ, ∂φ/∂r and ∫ tr J.
    pub derivatives: bool,
    /// Extrema of every state.
    pub extrema: bool,
    /// Samples of the motion, dense enough to draw.
    pub path: bool,
    /// The factors of Φ, for multipliers that would underflow in their product.
    pub factors: bool,
}

/// One motion from a place to another.
#[derive(Debug, Clone, PartialEq)]
pub struct Passage<const N: usize, Mode> {
    /// Where it ended.
    pub end: Place<N, Mode>,
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
    /// Where the motion is calmest: a good place to begin an orbit.
    pub calm: Calm<N, Mode>,
    /// What it cost.
    pub work: Work,
}

/// The place between two steps of which the shorter one is longest.
///
/// Next to a short step something is about to happen, or has just happened: a start there would
/// soon fall before it or behind it as the design variable changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Calm<const N: usize, Mode> {
    /// When, from the beginning of the passage.
    pub time: f64,
    /// Length of the shorter step beside it.
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

/// How the end of a passage depends on its beginning, on the design variable and on its duration.
#[derive(Debug, Clone, PartialEq)]
pub struct Derivatives<const N: usize> {
    /// Φ = ∂φ/∂y.
    pub state: [[f64; N]; N],
    /// ∂φ/∂r.
    pub design: [f64; N],
    /// ∂φ/∂t: the velocity at the end.
    pub time: [f64; N],
    /// ∫ tr J dt over the smooth stretches: ln det Φ by Liouville where no event lies between.
    pub trace: f64,
    /// Factors of Φ = Fₘ ⋯ F₁ in the order of time, if wanted.
    pub factors: Vec<Factor<N>>,
    /// The most internal states that rested on their stops at once: as many multipliers of an orbit are exactly zero,
    /// and `trace` says nothing of Φ.
    pub lost: usize,
}

/// A factor of Φ over one stretch of a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Factor<const N: usize> {
    /// ∂(end)/∂(beginning) of the stretch.
    pub state: [[f64; N]; N],
    /// ∫ J dt over the stretch, where an implicit step damps what decays fast far less than the motion does.
    pub growth: Option<[[f64; N]; N]>,
}

/// A local extremum of one state along a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extremum<const N: usize> {
    /// Which state.
    pub index: usize,
    /// Whether it is a maximum.
    pub maximum: bool,
    /// When, from the beginning of the passage.
    pub time: f64,
    /// The whole state there.
    pub state: [f64; N],
}

/// A stretch of a motion in constant mode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment<Mode> {
    /// The modes of the contacts during it.
    pub mode: Mode,
    /// Its duration.
    pub duration: f64,
}

/// A state on a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample<const N: usize> {
    /// Time from the beginning of the passage.
    pub time: f64,
    /// State at that time.
    pub state: [f64; N],
}

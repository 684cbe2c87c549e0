//! Why a motion cannot be followed, or has no derivative.

use super::sensitivity::SensitivityUndefined;
use crate::field::SmoothingError;
use crate::field::exact::{ContactError, Mode};
use crate::integrate::IntegrationError;
use crate::model::{ContactId, ParameterError, Values, brief, listed};

/// Why a motion could not be followed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FlowError {
    /// The integrator gave up.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
    /// A state has left all bounds.
    #[error(
        "the motion grows without bound: `{state}` passed {} at t = {}, where {cause}",
        brief(*.value),
        brief(*.time)
    )]
    Unbounded {
        /// The state that grew most.
        state: &'static str,
        /// What it had become.
        value: f64,
        /// When.
        time: f64,
        /// Why the motion could not be followed any further.
        cause: &'static str,
    },
    /// A formula of the model is not finite.
    #[error("at t = {}, where {state}, {culprit}", brief(*.time))]
    Undefined {
        /// Which, in words.
        culprit: String,
        /// When.
        time: f64,
        /// Where.
        state: Values,
    },
    /// A law was used outside the bounds of its fields.
    #[error(
        "the friction `{force}` has no law at t = {}: `{law}` wants {bound}, and there it {} {}{}, where {state}",
        brief(*.time),
        if *.passes { "passes" } else { "is" },
        brief(*.value),
        if *.passes && *.value == 0.0 { " (what may lift off is a `press`)" } else { "" }
    )]
    OutOfLaw {
        /// The force.
        force: &'static str,
        /// Its law.
        law: &'static str,
        /// The bounds of the field, as a user writes them.
        bound: String,
        /// The value of the field.
        value: f64,
        /// Whether it passes its bound there, and was inside before.
        passes: bool,
        /// When.
        time: f64,
        /// Where.
        state: Values,
    },
    /// A smoothing was used outside the sliding direction for which it stands.
    #[error(
        "the smoothing stands for one sliding direction only, but contact {contact} slides backwards at t = {}: \
         relative speed {speed:e}",
        brief(*.time)
    )]
    Backwards {
        /// Which.
        contact: ContactId,
        /// When.
        time: f64,
        /// Relative speed, signed.
        speed: f64,
    },
    /// A parameter that the model does not accept.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// Forces at rest that are not determined.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// A contact that can neither stick nor slide the way it should.
    #[error(
        "contact {contact} is to be in mode {mode} at t = {}, but its {} is {}{}",
        brief(*.time),
        measured(*.mode),
        brief(*.speed),
        rates(*.rate, *.second_rate)
    )]
    InconsistentMode {
        /// Which.
        contact: ContactId,
        /// When.
        time: f64,
        /// The mode it should be in.
        mode: Mode,
        /// Relative speed w, of a press the gap.
        speed: f64,
        /// ẇ.
        rate: f64,
        /// ẅ.
        second_rate: f64,
    },
    /// A state behind a wall that does not give way.
    #[error("contact {contact} does not give way, and its gap is {gap:e}: begin where it is open")]
    Inside {
        /// Which.
        contact: ContactId,
        /// Its gap, below zero.
        gap: f64,
    },
    /// Presses that do not give way, of which none and all would bear.
    #[error(
        "at t = {} no reactions are consistent at contacts {}: whichever of them bear, some would pull, or close further",
        brief(*.time),
        listed(.contacts)
    )]
    NotBorne {
        /// The contacts whose gaps are closed.
        contacts: Vec<ContactId>,
        /// When.
        time: f64,
    },
    /// An impact whose friction would have to know how the speed changes during it.
    #[error(
        "contact {contact} is hit at t = {}, and the friction of contact {friction} under it changes with speed: its impulse \
         is defined only for a law that grows with the reaction at the same rate at every speed",
        brief(*.time)
    )]
    Impulsive {
        /// The press.
        contact: ContactId,
        /// The contact that rubs.
        friction: ContactId,
        /// When.
        time: f64,
    },
    /// An impact with friction that has no solution.
    #[error("contact {contact} is hit at t = {}, and no impulses of it and its friction are consistent", brief(*.time))]
    NoImpulse {
        /// The press.
        contact: ContactId,
        /// When.
        time: f64,
    },
    /// Newton's restitution would make energy of friction.
    #[error(
        "contact {contact} is hit at t = {}, and with its restitution and friction the motion would gain the energy \
         {energy:e}: Newton's law of impact says nothing there",
        brief(*.time)
    )]
    Gains {
        /// The press.
        contact: ContactId,
        /// When.
        time: f64,
        /// Work of all impulses.
        energy: f64,
    },
    /// Impacts at one time.
    #[error(
        "contacts {} are hit together at t = {time}: what follows depends on the order of their impacts",
        listed(.contacts)
    )]
    HitTogether {
        /// Which.
        contacts: Vec<ContactId>,
        /// When.
        time: f64,
    },
    /// Event upon event in next to no time.
    #[error("{events} events in no time at contact {contact}, up to t = {}", brief(*.time))]
    Chattering {
        /// That which was last.
        contact: ContactId,
        /// When.
        time: f64,
        /// How many.
        events: u64,
    },
    /// An event at which the motion has no derivative.
    #[error(transparent)]
    SensitivityUndefined(#[from] SensitivityUndefined),
    /// The smoothing would falsify a law.
    #[error(transparent)]
    Smoothing(#[from] SmoothingError),
    /// A periodic orbit has shrunk to a point.
    #[error("the orbit has shrunk to an equilibrium at {state}")]
    Vanished {
        /// Where.
        state: Values,
    },
    /// A motion that should close comes back in another mode.
    #[error("the motion comes back in mode {found}, but began in mode {wanted}")]
    OtherMode {
        /// Modes of the contacts at the end.
        found: String,
        /// Modes of the contacts at the start.
        wanted: String,
    },
    /// What was held in a neutral direction, which is neutral no more.
    #[error(
        "orbits are singled out by a condition that holds no more: with it the motion closes to {closure:.1e} only"
    )]
    Unpinned {
        /// How far the end is from the start, relative to the extents of the states.
        closure: f64,
    },
    /// A motion that runs on over a length that is another one now.
    #[error(
        "the motion runs on by a length that changes here: take as a state how many of these it has passed, as in x/a, and \
         a length of 1"
    )]
    Unshifted,
    /// A contact that stuck all along lets go: what it held in one place slides.
    #[error(
        "friction lets go what it has held in one place all along; an orbit that is held elsewhere, or that slides, is one to \
         begin anew with"
    )]
    LetsGo,
    /// A drive that stands still, or turns backwards.
    #[error(
        "the drive `{name}` advances at the rate {rate}, which must be a finite number above 0"
    )]
    Standing {
        /// The phase.
        name: &'static str,
        /// Its rate.
        rate: f64,
    },
    /// A drive that turns too often in a time for all its turns to be noted.
    #[error("the drive turns {turns:.1e} times in the time {}: so many turns cannot be followed at once", brief(*.time))]
    TooManyTurns {
        /// How often.
        turns: f64,
        /// The time.
        time: f64,
    },
    /// The stops of an internal state that stand nowhere.
    #[error(
        "`{law}` stops `{state}` at {bound}, which must be a finite number above 0: give its parameters other values"
    )]
    Misplaced {
        /// The state.
        state: &'static str,
        /// The law.
        law: &'static str,
        /// Where it should stop.
        bound: f64,
    },
    /// Internal states with stops, which an exact motion does not know.
    #[error("`{law}` has stops, and the exact form of dry friction knows none: take a smooth copy")]
    NoExactStops {
        /// The law.
        law: &'static str,
    },
    /// A duration that is negative or not finite.
    #[error("a motion cannot be followed for the time {}", brief(*.time))]
    BadTime {
        /// The duration.
        time: f64,
    },
}

/// What says in which mode a contact is.
fn measured(mode: Mode) -> &'static str {
    if mode.is_of_press() {
        "gap"
    } else {
        "relative speed"
    }
}

/// How it changes, where that was looked at.
fn rates(first: f64, second: f64) -> String {
    if first == 0.0 && second == 0.0 {
        String::new()
    } else {
        format!(", with rates {} and {}", brief(first), brief(second))
    }
}

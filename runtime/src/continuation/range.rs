//! How far a branch is followed, in what steps, and why it ended.

use std::fmt;

use super::corrector::Failure;
use super::point::Base;

/// How a branch is followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Where r begins.
    pub from: f64,
    /// Where r shall end.
    pub to: f64,
    /// Corrections at most this, relative to the scale of the unknowns, end an iteration.
    pub accuracy: f64,
    /// First step, as an arclength in scaled coordinates, r in its own magnitude along the branch.
    pub first_step: f64,
    /// Smallest step.
    pub smallest_step: f64,
    /// Largest step.
    pub largest_step: f64,
    /// Largest angle between tangent and chord (2.21), rad.
    pub beta_1: f64,
    /// Largest angle between tangent and chord without r (2.22), rad.
    pub beta_2: f64,
    /// Most points.
    pub points: usize,
}

impl Settings {
    /// The usual settings for r from `from` to `to`.
    #[must_use]
    pub fn new(from: f64, to: f64, accuracy: f64) -> Self {
        Self {
            from,
            to,
            accuracy,
            first_step: 0.02,
            smallest_step: 1e-7,
            largest_step: 0.5,
            beta_1: 0.35,
            beta_2: 0.7,
            points: 10_000,
        }
    }
}

impl Settings {
    /// Whether r lies between both ends of the range, and at neither.
    pub(crate) fn contains(&self, r: f64) -> bool {
        (r - self.from) * (r - self.to) < 0.0
    }

    /// The end of the range that lies between r = `base` and `r`, or at `r`; `None` if `r` is inside. From outside, it is the
    /// end by which the range was left.
    pub(super) fn passed<E>(&self, base: f64, r: f64) -> Option<(f64, Stop<E>)> {
        let (from, to) = (self.from, self.to);
        let outside = self.left(base);
        if outside.is_some() {
            outside
        } else if (r - to) * (to - from) >= 0.0 {
            Some((to, Stop::ReachedEnd))
        } else if (r - from) * (to - from) <= 0.0 && base != from {
            Some((from, Stop::ReachedStart))
        } else {
            None
        }
    }

    /// The end of the range beyond which `r` lies; `None` if it lies at neither.
    pub(super) fn left<E>(&self, r: f64) -> Option<(f64, Stop<E>)> {
        let (from, to) = (self.from, self.to);
        if (r - to) * (to - from) > 0.0 {
            Some((to, Stop::ReachedEnd))
        } else if (r - from) * (to - from) < 0.0 {
            Some((from, Stop::ReachedStart))
        } else {
            None
        }
    }
}

impl<E: fmt::Display> fmt::Display for Stop<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::ReachedEnd => f.write_str("the end of its range is reached"),
            Self::ReachedStart => f.write_str("it turned and came back to where its range begins"),
            Self::StepTooSmall(failure) => write!(f, "no step is small enough: {failure}"),
            Self::Creeping(length) => {
                write!(
                    f,
                    "no step was longer than {length:e} of its extent for too long"
                )
            }
            Self::Upright(points) => write!(
                f,
                "it stands upright, as along a canard: {points} points in a row do not differ in the parameter"
            ),
            Self::TooManyPoints => f.write_str("it has more points than are allowed"),
            Self::Refused(error) => error.fmt(f),
        }
    }
}

/// Why a branch ended.
#[derive(Debug, Clone, PartialEq)]
pub enum Stop<E> {
    /// r reached its end.
    ReachedEnd,
    /// r came back to where it began.
    ReachedStart,
    /// The step fell below the smallest; with the last reason: (2.23).
    StepTooSmall(Failure<E>),
    /// No step was longer than this for so long that it leads nowhere.
    Creeping(f64),
    /// r stood still to its last digits for so many points: what follows is no other value of r.
    Upright(usize),
    /// The limit of points.
    TooManyPoints,
    /// The problem says that the branch ends here.
    Refused(E),
}

/// The point before a corner, and why no step from there was short enough.
pub(super) type Corner<Extra, E> = (Base<Extra>, Stop<E>);

impl<E> Stop<E> {
    /// Whether the branch goes on as far as is known, and no step leads anywhere.
    #[must_use]
    pub fn is_stuck(&self) -> bool {
        matches!(
            self,
            Self::StepTooSmall(_) | Self::Creeping(_) | Self::Upright(_)
        )
    }
}

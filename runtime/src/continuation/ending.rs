//! Why a branch that is walked along ends.

use super::kind::Kind;
use super::located::Unexplained;
use super::range::Stop;

/// How a point is not any more what was followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Lost {
    /// Its condition is off by this.
    Off(f64),
    /// It has become another kind: points of both kinds are one between it and the last.
    Becomes(Kind),
    /// What vanishes there is largest, and not least.
    Largest,
}

/// Why a branch ended.
#[derive(Debug, Clone, PartialEq)]
pub enum Ending<E> {
    /// There are no more steps.
    Stopped(Stop<E>),
    /// At a special point beyond which nothing continues it, or nothing that can be reached.
    At(Kind, f64),
    /// At a special point beyond which something should continue it that was not found.
    Undecided(Kind, f64),
    /// It has become another branch there, at such a point of that, along which it would only run back.
    Meets(Kind, f64),
    /// It cannot be told any more from orbits that it has come by, or from a shorter one, however short the step.
    FallsBack(f64),
    /// It came round to where it began.
    Closed(f64),
    /// It leaves what was asked for.
    Left,
    /// Its period has grown this many times.
    Endless(f64),
    /// It grows without bound as r comes to this value.
    Unbounded(f64),
    /// It comes at this value of r to what leaves an equilibrium and comes back to it, and lasts ever longer.
    Homoclinic(f64),
    /// It goes on changing at this value of r, any of it as good as the rest.
    Family(f64),
    /// It is not any more what was followed.
    Lost(Lost),
    /// Whoever watched wanted no more.
    Interrupted,
    /// A change that no special point explains.
    Unexplained(Unexplained),
}

impl<E> Ending<E> {
    /// Whether whoever watched wanted no more.
    #[must_use]
    pub fn is_interrupted(&self) -> bool {
        matches!(self, Self::Interrupted)
    }
}

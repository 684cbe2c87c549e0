//! How friction acts.

use std::fmt;

use crate::field::Smoothing;

/// How friction acts in a system.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Dynamics {
    /// There is none.
    Smooth,
    /// By its set-valued law.
    Exact,
    /// By a smooth copy of its law.
    Smoothed(Smoothing),
}

impl fmt::Display for Dynamics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Smooth => f.write_str("smooth"),
            Self::Exact => f.write_str("exact"),
            Self::Smoothed(smoothing) => smoothing.fmt(f),
        }
    }
}

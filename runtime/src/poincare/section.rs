//! Sections as data.

use crate::words::words;

/// A surface in phase space, and the direction in which crossings of it count.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Section {
    /// The surface.
    pub surface: Surface,
    /// Which crossings count.
    pub direction: Direction,
}

/// Where a function of the state vanishes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Surface {
    /// The rate of the state of this index: where that state is extremal.
    Rate(usize),
    /// A state less a value.
    Level {
        /// Index of the state.
        state: usize,
        /// The value.
        value: f64,
    },
}

words! {
    /// The direction of a crossing: whether the function that vanishes grows through zero.
    pub enum Direction {
        /// It grows.
        Up = "up",
        /// It falls.
        Down = "down",
        /// Either.
        Both = "both",
    }
}

impl Default for Section {
    /// der(first state) = 0, upwards: the thesis's X₁' = 0.
    fn default() -> Self {
        Self::least(0)
    }
}

impl Section {
    /// Where this state is least: its rate vanishes, upwards.
    #[must_use]
    pub const fn least(state: usize) -> Self {
        Self {
            surface: Surface::Rate(state),
            direction: Direction::Up,
        }
    }

    /// Where the phase of the drive begins anew, if a state is one; else der(first state) = 0, upwards.
    #[must_use]
    pub fn usual(phase: Option<usize>) -> Self {
        let strobe = |state| Self {
            surface: Surface::Level { state, value: 0.0 },
            direction: Direction::Up,
        };
        phase.map_or_else(Self::default, strobe)
    }
}

impl Surface {
    /// The state that it is about.
    #[must_use]
    pub const fn state(&self) -> usize {
        match self {
            Self::Rate(state) | Self::Level { state, .. } => *state,
        }
    }
}

impl Direction {
    /// Whether a crossing that rises, or one that falls, counts.
    #[must_use]
    pub const fn admits(self, rising: bool) -> bool {
        match self {
            Self::Up => rising,
            Self::Down => !rising,
            Self::Both => true,
        }
    }
}

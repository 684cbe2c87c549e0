//! The kinds of bifurcations of periodic orbits.

/// What changes at a special point of a branch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Kind {
    /// A multiplier passes through 1 and the branch turns.
    Fold,
    /// A multiplier passes through −1: period doubling.
    Flip,
    /// Two conjugate multipliers leave the unit circle: Neimark-Sacker.
    Torus,
    /// A multiplier passes through 1 and the branch goes straight on: another one crosses.
    BranchPoint,
    /// A branch point where the branch that crosses loses a symmetry of the orbit.
    SymmetryBreaking,
    /// A crossing turns into a short stick.
    CrossingSliding,
    /// A sliding contact comes to rest for a moment.
    GrazingSliding,
    /// A contact comes to rest at the edge of where it can stick.
    SwitchingSliding,
    /// A sticking contact reaches the limit of its force for a moment.
    AddingSliding,
    /// A stretch of constant mode loses its duration.
    VanishingSegment,
}

impl Kind {
    /// The word for it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Fold => "fold",
            Self::Flip => "flip",
            Self::Torus => "torus",
            Self::BranchPoint => "branch-point",
            Self::SymmetryBreaking => "symmetry-breaking",
            Self::CrossingSliding => "crossing-sliding",
            Self::GrazingSliding => "grazing-sliding",
            Self::SwitchingSliding => "switching-sliding",
            Self::AddingSliding => "adding-sliding",
            Self::VanishingSegment => "vanishing-segment",
        }
    }

    /// The letters of its label: LP1, PD1, ...
    #[must_use]
    pub const fn letters(self) -> &'static str {
        match self {
            Self::Fold => "LP",
            Self::Flip => "PD",
            Self::Torus => "NS",
            Self::BranchPoint => "BP",
            Self::SymmetryBreaking => "SB",
            Self::CrossingSliding => "CS",
            Self::GrazingSliding => "GS",
            Self::SwitchingSliding => "SS",
            Self::AddingSliding => "AS",
            Self::VanishingSegment => "VS",
        }
    }

    /// By how many the number of unstable multipliers changes; `None` if it may be any number.
    pub(super) const fn jump(self) -> Option<i64> {
        match self {
            Self::Fold | Self::Flip | Self::BranchPoint | Self::SymmetryBreaking => Some(1),
            Self::Torus => Some(2),
            _ => None,
        }
    }
}

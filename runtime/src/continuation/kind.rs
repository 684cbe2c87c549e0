//! The kinds of special points of a branch, of whatever it is one.

use std::fmt;

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
    /// A complex pair of eigenvalues crosses the imaginary axis: periodic orbits begin at this equilibrium.
    Hopf,
    /// Two pairs of eigenvalues collide on the imaginary axis and leave it to both sides: modes of vibration couple.
    Flutter,
    /// Two pairs of multipliers collide on the unit circle and leave it to both sides, being of opposite signature.
    Krein,
    /// The relative speed of a contact reaches zero at an equilibrium: its mode ends.
    BoundaryEquilibrium,
    /// The quadratic coefficient of a fold vanishes: its curve turns back in both variables at once.
    Cusp,
    /// A multiplier 1 beside a multiplier −1.
    FoldFlip,
    /// Two multipliers 1.
    Resonance1,
    /// Two multipliers −1.
    Resonance2,
    /// A pair at a third of a turn.
    Resonance3,
    /// A pair at a quarter of a turn.
    Resonance4,
    /// The first design variable of a curve leaves its range.
    Window,
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// By its word.
#[cfg(feature = "app")]
impl serde::Serialize for Kind {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
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
            Self::Hopf => "hopf",
            Self::Flutter => "flutter",
            Self::Krein => "krein-collision",
            Self::BoundaryEquilibrium => "boundary-equilibrium",
            Self::Cusp => "cusp",
            Self::FoldFlip => "fold-flip",
            Self::Resonance1 => "resonance-1-1",
            Self::Resonance2 => "resonance-1-2",
            Self::Resonance3 => "resonance-1-3",
            Self::Resonance4 => "resonance-1-4",
            Self::Window => "left-range",
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
            Self::Hopf => "HB",
            Self::Flutter => "FL",
            Self::Krein => "KC",
            Self::BoundaryEquilibrium => "BE",
            Self::Cusp => "CP",
            Self::FoldFlip => "LPPD",
            Self::Resonance1 => "R1-",
            Self::Resonance2 => "R2-",
            Self::Resonance3 => "R3-",
            Self::Resonance4 => "R4-",
            Self::Window => "WB",
        }
    }

    /// By how many the number of unstable directions changes; `None` if it may be any number.
    pub(super) const fn jump(self) -> Option<i64> {
        match self {
            Self::Fold | Self::Flip | Self::BranchPoint | Self::SymmetryBreaking => Some(1),
            Self::Torus | Self::Hopf | Self::Flutter | Self::Krein => Some(2),
            _ => None,
        }
    }
}

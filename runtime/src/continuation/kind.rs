//! The kinds of special points of a branch, of whatever it is one.

use crate::words::words;

words! {
    /// What changes at a special point of a branch.
    pub enum Kind {
        /// A multiplier passes through 1 and the branch turns.
        Fold = "fold",
        /// A multiplier passes through −1: period doubling.
        Flip = "flip",
        /// Two conjugate multipliers leave the unit circle: Neimark-Sacker.
        Torus = "torus",
        /// A multiplier passes through 1 and the branch goes straight on: another one crosses.
        BranchPoint = "branch-point",
        /// A branch point where the branch that crosses loses a symmetry of the orbit.
        SymmetryBreaking = "symmetry-breaking",
        /// A crossing turns into a short stick.
        CrossingSliding = "crossing-sliding",
        /// A sliding contact comes to rest for a moment.
        GrazingSliding = "grazing-sliding",
        /// A gap closes for a moment, or opens for one.
        Grazing = "grazing",
        /// A contact comes to rest at the edge of where it can stick.
        SwitchingSliding = "switching-sliding",
        /// A sticking contact reaches the limit of its force for a moment.
        AddingSliding = "adding-sliding",
        /// A stretch of constant mode loses its duration.
        VanishingSegment = "vanishing-segment",
        /// A complex pair of eigenvalues crosses the imaginary axis: periodic orbits begin at this equilibrium.
        Hopf = "hopf",
        /// Two pairs of eigenvalues collide on the imaginary axis and leave it to both sides: modes of vibration couple.
        Flutter = "flutter",
        /// Two pairs of multipliers collide on the unit circle and leave it to both sides, being of opposite signature.
        Krein = "krein-collision",
        /// The relative speed of a contact reaches zero at an equilibrium: its mode ends.
        BoundaryEquilibrium = "boundary-equilibrium",
        /// The quadratic coefficient of a fold vanishes: its curve turns back in both variables at once.
        Cusp = "cusp",
        /// A curve of folds stands still in one variable, at which a closed branch along the other shrinks to this point.
        IsolaCentre = "isola-centre",
        /// A curve of folds stands still in one variable, at which two branches along the other meet and exchange their parts:
        /// there an isola joins another branch, or leaves it.
        Exchange = "branch-exchange",
        /// A multiplier 1 beside a multiplier −1.
        FoldFlip = "fold-flip",
        /// Two multipliers 1.
        Resonance1 = "resonance-1-1",
        /// Two multipliers −1.
        Resonance2 = "resonance-1-2",
        /// A pair at a third of a turn.
        Resonance3 = "resonance-1-3",
        /// A pair at a quarter of a turn.
        Resonance4 = "resonance-1-4",
        /// The first Lyapunov coefficient of a Hopf point vanishes: on one side motions begin softly there, on the other hard.
        GeneralizedHopf = "generalized-hopf",
        /// Two eigenvalues 0, one of them because a pair on the imaginary axis ends there.
        BogdanovTakens = "bogdanov-takens",
        /// An eigenvalue 0 beside a pair on the imaginary axis.
        ZeroHopf = "zero-hopf",
        /// Two pairs on the imaginary axis.
        DoubleHopf = "double-hopf",
        /// The first design variable of a curve leaves its range.
        Window = "left-range",
    }
}

impl Kind {
    /// Whether orbits are there on the border between two orders of events, met by equations of its own.
    #[must_use]
    pub const fn is_border(self) -> bool {
        matches!(
            self,
            Self::CrossingSliding
                | Self::GrazingSliding
                | Self::Grazing
                | Self::SwitchingSliding
                | Self::AddingSliding
        )
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
            Self::Grazing => "GR",
            Self::SwitchingSliding => "SS",
            Self::AddingSliding => "AS",
            Self::VanishingSegment => "VS",
            Self::Hopf => "HB",
            Self::Flutter => "FL",
            Self::Krein => "KC",
            Self::BoundaryEquilibrium => "BE",
            Self::Cusp => "CP",
            Self::IsolaCentre => "IC",
            Self::Exchange => "BX",
            Self::FoldFlip => "LPPD",
            Self::Resonance1 => "R1-",
            Self::Resonance2 => "R2-",
            Self::Resonance3 => "R3-",
            Self::Resonance4 => "R4-",
            Self::GeneralizedHopf => "GH",
            Self::BogdanovTakens => "BT",
            Self::ZeroHopf => "ZH",
            Self::DoubleHopf => "HH",
            Self::Window => "WB",
        }
    }

    /// By how many the number of unstable directions changes; `None` if it may be any number.
    pub(crate) const fn jump(self) -> Option<i64> {
        match self {
            Self::Fold | Self::Flip | Self::BranchPoint | Self::SymmetryBreaking => Some(1),
            Self::Torus | Self::Hopf | Self::Flutter | Self::Krein => Some(2),
            _ => None,
        }
    }
}

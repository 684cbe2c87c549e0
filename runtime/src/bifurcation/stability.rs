//! The verdict on a steady motion.

/// What multipliers say of a periodic orbit, or eigenvalues of an equilibrium.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(
    feature = "app",
    derive(serde::Serialize),
    serde(rename_all = "lowercase")
)]
pub enum Stability {
    /// All multipliers lie inside the unit circle, all eigenvalues left of the axis.
    Stable,
    /// At least one lies outside, beyond its error.
    Unstable,
    /// One lies on the circle, or on the axis, as far as its error tells.
    Undecided,
}

impl Stability {
    /// The word for it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Stable => "stable",
            Self::Unstable => "unstable",
            Self::Undecided => "undecided",
        }
    }
}

//! The verdict on a steady motion.

use crate::words::words;

words! {
    /// What multipliers say of a periodic orbit, or eigenvalues of an equilibrium.
    pub enum Stability {
        /// All multipliers lie inside the unit circle, all eigenvalues left of the axis.
        Stable = "stable",
        /// At least one lies outside, beyond its error.
        Unstable = "unstable",
        /// One lies on the circle, or on the axis, as far as its error tells.
        Undecided = "undecided",
    }
}

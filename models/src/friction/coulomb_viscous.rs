//! Coulomb's law with a viscous part.

use stickslip::friction_law;

friction_law! {
    /// Coulomb's law with a viscous part: the force grows in proportion to the sliding speed.
    ///
    /// With F_c = `level`, σ = `viscous`:
    ///
    /// |F| ≤ F_c at rest, F_c + σ s at the sliding speed s
    ///
    /// Source: the textbook form, after C. A. de Coulomb, 1785, and O. Reynolds, 1886.
    pub struct CoulombViscous {
        /// Largest force at rest, and limit of the force at slow sliding.
        param level: N where level >= 0.0;
        /// Force that grows with speed.
        param viscous: N*s/m where viscous >= 0.0;

        stick = level;
        slip(s) = level + viscous * s;
    }
}

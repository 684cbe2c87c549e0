//! Coulomb's law.

use stickslip::friction_law;

friction_law! {
    /// Coulomb's law: the same force at rest and at any sliding speed.
    ///
    /// With F_c = `level`:
    ///
    /// |F| ≤ F_c at rest, F_c while sliding
    ///
    /// Source: C. A. de Coulomb, Théorie des machines simples, 1785.
    pub struct Coulomb {
        /// Force while sliding, and largest force at rest.
        param level: N where level >= 0.0;

        stick = level;
        slip(s) = level;
    }
}

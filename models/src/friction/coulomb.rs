//! Friction that does not depend on the sliding speed.

use stickslip::friction_law;

friction_law! {
    /// Coulomb's law: the same force at rest and at any sliding speed.
    pub struct Coulomb {
        /// Force while sliding, and largest force at rest.
        param level: N where level >= 0.0;

        stick = level;
        slip(s) = level;
    }
}

friction_law! {
    /// Coulomb's law with a larger force at rest: thesis Fig. 4.2, Jansen.
    pub struct CoulombStatic {
        /// Largest static force, not below the kinetic one.
        param static_level: N where static_level >= 0.0;
        /// Force while sliding.
        param kinetic_level: N where kinetic_level >= 0.0;

        stick = static_level;
        slip(s) = kinetic_level;
    }
}

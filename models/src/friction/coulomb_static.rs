//! Coulomb's law with a static peak.

use stickslip::friction_law;

friction_law! {
    /// Coulomb's law with a larger force at rest: thesis Fig. 4.2, Jansen.
    ///
    /// With F_s = `static_level`, F_c = `kinetic_level` ≤ F_s:
    ///
    /// |F| ≤ F_s at rest, F_c while sliding
    ///
    /// The force jumps as sliding begins: only a bump (`quartic`) smooths that without losing the peak.
    ///
    /// Source: J. D. Jansen, Nonlinear Dynamics of Oilwell Drillstrings, 1993.
    pub struct CoulombStatic {
        /// Largest static force, not below the kinetic one.
        param static_level: N where static_level >= 0.0;
        /// Force while sliding.
        param kinetic_level: N where kinetic_level >= 0.0;

        stick = static_level;
        slip(s) = kinetic_level;
    }
}

//! Friction that weakens, then grows with the square of the speed.

use stickslip::friction_law;

friction_law! {
    /// Popp and Stelter's law: friction weakens hyperbolically, then grows with the square of the speed.
    ///
    /// With F_s = `static_level`, F_m = `kinetic_level` ≤ F_s, δ = `decay`, η = `growth`:
    ///
    /// |F| ≤ F_s at rest, (F_s − F_m)/(1 + δ s) + F_m + η s² at the sliding speed s
    ///
    /// Source: K. Popp, P. Stelter, Phil. Trans. R. Soc. Lond. A 332, 1990.
    pub struct PoppStelter {
        /// Largest static force, not below the kinetic one.
        param static_level: N where static_level >= 0.0;
        /// Force to which friction would fall without its growth.
        param kinetic_level: N where kinetic_level >= 0.0;
        /// Rate at which the force decreases with speed.
        param decay: s/m where decay >= 0.0;
        /// Force that grows with the square of the speed.
        param growth: N*s^2/m^2 where growth >= 0.0;

        stick = static_level;
        slip(s) = (static_level - kinetic_level) / (1.0 + decay * s)
            + kinetic_level
            + growth * powi(s, 2);
    }
}

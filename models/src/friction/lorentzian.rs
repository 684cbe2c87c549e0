//! Stribeck's curve, Lorentzian.

use stickslip::friction_law;

friction_law! {
    /// Stribeck's curve in Hess and Soom's form: friction falls like a Lorentzian, with a long tail.
    ///
    /// With F_s = `static_level`, F_c = `kinetic_level` ≤ F_s, v_s = `speed`, σ = `viscous`:
    ///
    /// |F| ≤ F_s at rest, F_c + (F_s − F_c)/(1 + (s/v_s)²) + σ s at the sliding speed s
    ///
    /// Source: D. P. Hess, A. Soom, J. Tribology 112, 1990.
    pub struct Lorentzian {
        /// Largest static force, not below the kinetic one.
        param static_level: N where static_level >= 0.0;
        /// Force to which friction falls, without its viscous part.
        param kinetic_level: N where kinetic_level >= 0.0;
        /// Speed at which friction has fallen half of the way.
        param speed: m/s where speed > 0.0;
        /// Force that grows with speed.
        param viscous: N*s/m where viscous >= 0.0;

        stick = static_level;
        slip(s) = kinetic_level
            + (static_level - kinetic_level) / (1.0 + powi(s / speed, 2))
            + viscous * s;
    }
}

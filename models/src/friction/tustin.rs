//! Stribeck's curve, exponential.

use stickslip::friction_law;

friction_law! {
    /// Stribeck's curve in Tustin's form: friction falls exponentially from the first speed on.
    ///
    /// With F_s = `static_level`, F_c = `kinetic_level` ≤ F_s, v_s = `speed`, σ = `viscous`:
    ///
    /// |F| ≤ F_s at rest, F_c + (F_s − F_c) exp(−s/v_s) + σ s at the sliding speed s
    ///
    /// Source: A. Tustin, J. IEE 94 (2A), 1947.
    pub struct Tustin {
        /// Largest static force, not below the kinetic one.
        param static_level: N where static_level >= 0.0;
        /// Force to which friction falls, without its viscous part.
        param kinetic_level: N where kinetic_level >= 0.0;
        /// Speed at which friction has fallen by 1 - 1/e of the way.
        param speed: m/s where speed > 0.0;
        /// Force that grows with speed.
        param viscous: N*s/m where viscous >= 0.0;

        stick = static_level;
        slip(s) = kinetic_level + (static_level - kinetic_level) * exp(-s / speed) + viscous * s;
    }
}

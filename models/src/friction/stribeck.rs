//! Friction that falls from its static to its kinetic level as a film builds up.

use stickslip::friction_law;

friction_law! {
    /// Stribeck's curve with a viscous part: Bo and Pavelescu's exponential form.
    ///
    /// With F_s = `static_level`, F_c = `kinetic_level` ≤ F_s, v_s = `speed`, a = `exponent`, σ = `viscous`:
    ///
    /// |F| ≤ F_s at rest, F_c + (F_s − F_c) exp(−(s/v_s)^a) + σ s at the sliding speed s
    ///
    /// Exponent 1 is Tustin's law, exponent 2 the Gaussian form; below 1 the slope at rest would be infinite.
    ///
    /// Source: L. C. Bo, D. Pavelescu, Wear 82, 1982.
    pub struct Stribeck {
        /// Largest static force, not below the kinetic one.
        param static_level: N where static_level >= 0.0;
        /// Force to which friction falls, without its viscous part.
        param kinetic_level: N where kinetic_level >= 0.0;
        /// Speed at which friction has fallen by 1 - 1/e of the way.
        param speed: m/s where speed > 0.0;
        /// Shape of the fall.
        param exponent: 1 where exponent >= 1.0;
        /// Force that grows with speed.
        param viscous: N*s/m where viscous >= 0.0;

        stick = static_level;
        slip(s) = kinetic_level
            + (static_level - kinetic_level) * exp(-powf(s / speed, exponent))
            + viscous * s;
    }
}

//! Friction as a cubic polynomial of the speed.

use stickslip::friction_law;

friction_law! {
    /// Thomsen and Fidlin's law: a cubic polynomial that falls to its minimum and rises again.
    ///
    /// With F_s = `static_level`, F_m = `minimum` ≤ F_s, v_m = `speed`:
    ///
    /// |F| ≤ F_s at rest, F_s − (3/2)(F_s − F_m)(s/v_m − (s/v_m)³/3) at the sliding speed s
    ///
    /// It has the value F_s again at √3 v_m and grows with the third power beyond: it describes friction up to a few v_m.
    ///
    /// Source: J. J. Thomsen, A. Fidlin, Int. J. Non-Linear Mechanics 38, 2003.
    pub struct ThomsenFidlin {
        /// Largest static force, not below the minimum.
        param static_level: N where static_level >= 0.0;
        /// Least force while sliding.
        param minimum: N where minimum >= 0.0;
        /// Speed at which the force is least.
        param speed: m/s where speed > 0.0;

        stick = static_level;
        slip(s) = static_level
            - 1.5 * (static_level - minimum) * (s / speed - powi(s / speed, 3) / 3.0);
    }
}

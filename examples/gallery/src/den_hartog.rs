//! A mass that is shaken on rough ground.
//!
//! J. P. Den Hartog, Forced vibrations with combined Coulomb and viscous friction, Trans. ASME 53 (1931) APM-53-9:
//! the amplitude of motions without stops is a closed form. Time in 1/ω_n, displacements in static deflections, forces
//! in the amplitude of the exciting force. Stability after S. W. Shaw, On the dynamic response of a system with dry
//! friction, J. Sound and Vibration 108 (1986) 305.

use stickslip::model;
use stickslip_models::friction::Coulomb;

model! {
    /// A forced oscillator with Coulomb friction against fixed ground: Den Hartog 1931.
    pub struct DenHartog {
        state x: 1 = 1.0;
        state v: 1 = 0.0;
        /// Frequency of the force over the natural one.
        param beta: 1 = 0.6 where beta > 0.0;
        /// Friction over the amplitude of the force.
        param level: 1 = 0.2 where level >= 0.0;
        drive phi at beta;
        friction F: 1 = Coulomb { level } opposing v;
        der(x) = v;
        der(v) = cos(phi) - x + F;
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::DenHartog;
    use crate::asked::{case, close};

    /// Amplitude without stops, and the product of the multipliers: half a turn contracts areas by the ratio of the
    /// accelerations before and behind a turning point.
    fn closed_form(beta: f64, level: f64) -> (f64, f64) {
        let response = 1.0 / (1.0 - beta * beta);
        let half = PI / beta;
        let lost = level * half.sin() / (beta * (1.0 + half.cos()));
        let amplitude = (response * response - lost * lost).sqrt();
        let force = amplitude / response - amplitude;
        let ratio = (force + level) / (force - level);
        (amplitude, ratio * ratio)
    }

    #[track_caller]
    fn check(beta: f64, level: f64) {
        let model = DenHartog { beta, level };
        let (system, case) = case(&model);
        let orbit = system.orbit(&case).unwrap();
        let (amplitude, area) = closed_form(beta, level);
        close(orbit.max[0], amplitude, 1e-8 * amplitude, "amplitude");
        close(orbit.min[0], -amplitude, 1e-8 * amplitude, "amplitude");
        let multipliers = orbit.floquet.multipliers.iter();
        let found: f64 = multipliers.map(|multiplier| multiplier.norm()).product();
        close(found, area, 1e-6 * area, "product of the multipliers");
    }

    #[test]
    fn amplitude_and_stability_are_closed_forms() {
        for (beta, level) in [(0.6, 0.2), (0.8, 0.3), (1.3, 0.25), (2.0, 0.3)] {
            check(beta, level);
        }
    }

    #[test]
    fn they_are_near_resonance_too() {
        check(0.97, 0.5);
    }
}

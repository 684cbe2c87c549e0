//! A building on a hysteretic isolator.
//!
//! R. Bouc, 4th Conference on Nonlinear Oscillation, Prague 1967; Y.-K. Wen, Method for random vibration of hysteretic
//! systems, J. Eng. Mech. Div. ASCE 102 (1976) 249. The law with α = 0.1, A = 1, n = 1 is theirs; a mass of 1 and the
//! harmonic shaking of the ground are chosen here. The law's own y is the displacement of the isolator.

use stickslip::model;
use stickslip_models::friction::BoucWen;

model! {
    /// A mass on a Bouc-Wen isolator over ground that shakes: Wen 1976.
    pub struct Isolator {
        /// Displacement of the isolator.
        state y: m = 0.0;
        /// Its velocity.
        state v: m/s = 0.0;
        /// Hysteretic displacement.
        state z: m = 0.0;
        param mass: kg = 1.0 where mass > 0.0;
        param k: N/m = 1.0 where k > 0.0;
        /// Part of the stiffness that is left when the isolator has yielded.
        param left: 1 = 0.1 where 0.0 <= left <= 1.0;
        param beta: 1/m = 0.6 where beta > 0.0;
        param gamma: 1/m = 0.4;
        param c: N*s/m = 0.02 where c >= 0.0;
        /// Amplitude of the ground's acceleration.
        param shaking: m/s^2 = 0.8;
        param omega: rad/s = 0.7 where omega > 0.0;
        drive phi at omega;
        friction F: N = BoucWen { stiffness: k, left: left, slope: 1.0, beta: beta, gamma: gamma } opposing v with y, z;
        der(v) = (F - c * v) / mass - shaking * cos(phi);
    }
}

#[cfg(test)]
mod tests {
    use super::Isolator;
    use crate::asked::{case, close, returns};
    use crate::reference::Plant;

    impl Plant<3, 0> for Isolator {
        fn rate(&self, t: f64, &[y, v, z]: &[f64; 3], _: &[f64; 0]) -> [f64; 3] {
            let force = self.left * self.k * y + (1.0 - self.left) * self.k * z;
            let ground = self.shaking * (self.omega * t).cos();
            let yielding = v - self.beta * v.abs() * z - self.gamma * v * z.abs();
            [v, -(force + self.c * v) / self.mass - ground, yielding]
        }
        fn speeds(&self, _: &[f64; 3]) -> [f64; 0] {
            []
        }
        fn stick(&self, _: usize, _: &[f64; 3]) -> f64 {
            0.0
        }
        fn slip(&self, _: usize, _: f64, _: &[f64; 3]) -> f64 {
            0.0
        }
    }

    #[test]
    fn its_response_is_that_of_a_second_method() {
        for omega in [0.3, 0.7, 1.5] {
            let model = Isolator {
                omega,
                ..Isolator::default()
            };
            let (system, case) = case(&model);
            let orbit = system.orbit(&case).unwrap();
            returns(&orbit, &model, 1e-7);
            assert!(orbit.max[2] < 1.0 / (model.beta + model.gamma));
        }
    }

    /// Without yielding, α = 1, it is a linear oscillator.
    #[test]
    fn without_yielding_it_is_linear() {
        let model = Isolator {
            left: 1.0,
            ..Isolator::default()
        };
        let (system, case) = case(&model);
        let orbit = system.orbit(&case).unwrap();
        let stiffness = model.k - model.mass * model.omega.powi(2);
        let amplitude = model.mass * model.shaking / stiffness.hypot(model.c * model.omega);
        close(orbit.max[0], amplitude, 1e-8 * amplitude, "amplitude");
    }
}

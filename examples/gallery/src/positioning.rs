//! A servo that hunts around its target.
//!
//! C. Canudas de Wit, H. Olsson, K. J. Åström, P. Lischinsky, A new model for control of systems with friction, IEEE
//! Transactions on Automatic Control 40 (1995) 419: a mass of 1 kg under PID control with K_v = 6, K_p = 3, K_i = 4, and
//! the friction of Table I: σ₀ = 10⁵ N/m, σ₁ = √10⁵ N s/m, σ₂ = 0.4 N s/m, F_C = 1 N, F_S = 1.5 N, v_S = 0.001 m/s.

use stickslip::model;
use stickslip_models::friction::LuGre;

model! {
    /// A mass under PID control with LuGre friction: Canudas de Wit, Olsson, Åström and Lischinsky 1995.
    pub struct Positioning {
        /// Distance from the target.
        state x: m = -1.0;
        state v: m/s = 0.0;
        /// Integral of the distance.
        state i: m*s = 0.0;
        /// Deflection of the bristles.
        state z: m = 0.0;
        param mass: kg = 1.0 where mass > 0.0;
        param K_v: N*s/m = 6.0;
        param K_p: N/m = 3.0;
        param K_i: N/m/s = 4.0;
        param F_S: N = 1.5 where F_S > 0.0;
        friction F: N = LuGre { stiffness: 1e5, damping: 316.227766016838, viscous: 0.4, kinetic: 1.0, peak: F_S, stribeck: 0.001 } opposing v with z;
        der(x) = v;
        der(v) = (F - K_v * v - K_p * x - K_i * i) / mass;
        der(i) = x;
    }
}

#[cfg(test)]
mod tests {
    use super::Positioning;
    use crate::asked::{case, close, returns};
    use crate::reference::Plant;

    impl Plant<4, 0> for Positioning {
        fn rate(&self, _: f64, &[x, v, i, z]: &[f64; 4], _: &[f64; 0]) -> [f64; 4] {
            let steady = 1.0 + (self.F_S - 1.0) * (-(v / 0.001_f64).powi(2)).exp();
            let bending = v - 1e5 * v.abs() * z / steady;
            let friction = 1e5 * z + 1e5_f64.sqrt() * bending + 0.4 * v;
            let control = self.K_v * v + self.K_p * x + self.K_i * i;
            [v, -(friction + control) / self.mass, x, bending]
        }
        fn speeds(&self, _: &[f64; 4]) -> [f64; 0] {
            []
        }
        fn stick(&self, _: usize, _: &[f64; 4]) -> f64 {
            0.0
        }
        fn slip(&self, _: usize, _: f64, _: &[f64; 4]) -> f64 {
            0.0
        }
    }

    #[test]
    fn its_hunting_is_that_of_a_second_method() {
        let model = Positioning::default();
        let (system, case) = case(&model);
        let orbit = system.orbit(&case).unwrap();
        returns(&orbit, &model, 1e-6);
        close(orbit.max[0], -orbit.min[0], 1e-7, "to both sides alike");
    }
}

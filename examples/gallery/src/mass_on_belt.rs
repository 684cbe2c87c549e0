//! The classical mass on a belt.
//!
//! J. J. Thomsen, A. Fidlin, Analytical approximations for stick-slip vibration amplitudes, Int. J. Non-Linear Mechanics
//! 38 (2003) 389: nondimensional, with friction as a cubic polynomial of the speed. There μ_s = 0.4, μ_m = 0.25,
//! v_m = 0.5, β = 0.05, γ² = 1, as known here.

use stickslip::model;
use stickslip_models::friction::ThomsenFidlin;

model! {
    /// A mass on a belt whose friction has a minimum: Thomsen and Fidlin 2003.
    pub struct MassOnBelt {
        state u: 1 = 0.0;
        state v: 1 = 0.0;
        /// Damping ratio.
        param beta: 1 = 0.05 where beta >= 0.0;
        param mu_s: 1 = 0.4 where mu_s >= 0.0;
        param mu_m: 1 = 0.25 where mu_m >= 0.0;
        /// Speed of least friction.
        param v_m: 1 = 0.5 where v_m > 0.0;
        param belt: 1 = 0.1;
        friction F: 1 = ThomsenFidlin { static_level: mu_s, minimum: mu_m, speed: v_m } opposing v - belt;
        der(u) = v;
        der(v) = F - 2 * beta * v - u;
    }
}

#[cfg(test)]
mod tests {

    use stickslip::continuation::Kind;

    use super::MassOnBelt;
    use crate::asked::{case, close, returns, special};
    use crate::reference::Plant;

    impl Plant<2, 1> for MassOnBelt {
        fn rate(&self, _: f64, &[u, v]: &[f64; 2], &[friction]: &[f64; 1]) -> [f64; 2] {
            [v, friction - 2.0 * self.beta * v - u]
        }
        fn speeds(&self, &[_, v]: &[f64; 2]) -> [f64; 1] {
            [v - self.belt]
        }
        fn stick(&self, _: usize, _: &[f64; 2]) -> f64 {
            self.mu_s
        }
        fn slip(&self, _: usize, s: f64, _: &[f64; 2]) -> f64 {
            let r = s / self.v_m;
            self.mu_s - 1.5 * (self.mu_s - self.mu_m) * (r - r.powi(3) / 3.0)
        }
    }

    /// Steady sliding is unstable below v_b1 = v_m √(1 − 2β/k₁), k₁ = (3/2)(μ_s − μ_m)/v_m: damping and falling friction
    /// balance there.
    #[test]
    fn steady_sliding_loses_stability_where_the_closed_form_says() {
        let model = MassOnBelt::default();
        let (system, case) = case(&model);
        let case = case.following(MassOnBelt::belt, 0.05..0.8);
        let record = system.equilibria_along(&case);
        let (belt, frequency) = special(&record.unwrap(), Kind::Hopf);
        let slope = 1.5 * (model.mu_s - model.mu_m) / model.v_m;
        let expected = model.v_m * (1.0 - 2.0 * model.beta / slope).sqrt();
        close(belt, expected, 1e-9, "speed of the belt");
        close(frequency, 1.0, 1e-9, "frequency");
    }

    /// Thomsen and Fidlin's amplitude of motions that never stick, A = 2 √(v_b1² − v_b²): by averaging, so that it is off
    /// by the square of the friction's slope.
    #[test]
    fn pure_slip_has_the_published_amplitude() {
        for (drop, tolerance) in [(0.15, 1e-1), (0.015, 1e-3)] {
            let model = MassOnBelt {
                beta: drop / 3.0,
                mu_m: 0.4 - drop,
                belt: 0.42,
                ..MassOnBelt::default()
            };
            let slope = 1.5 * drop / model.v_m;
            let square = model.v_m.powi(2) * (1.0 - 2.0 * model.beta / slope) - model.belt.powi(2);
            let expected = 2.0 * square.sqrt();
            let (system, mut case) = case(&model);
            case.start = Some(vec![model.mu_m + expected, 0.0]);
            let orbit = system.orbit(&case).unwrap();
            assert_eq!(orbit.word.as_deref(), Some("slip-(F)"));
            let found = 0.5 * (orbit.max[0] - orbit.min[0]);
            close(found, expected, tolerance * expected, "amplitude");
        }
    }

    #[test]
    fn stick_slip_is_that_of_a_second_method() {
        for belt in [0.05, 0.1, 0.2] {
            let model = MassOnBelt {
                belt,
                ..MassOnBelt::default()
            };
            let (system, case) = case(&model);
            let motion = returns(&system.orbit(&case).unwrap(), &model, 1e-8);
            assert_eq!(motion.word, ["-", "s", "-"]);
        }
    }
}

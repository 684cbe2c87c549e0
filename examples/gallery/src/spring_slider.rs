//! A spring-slider with rate-and-state friction.
//!
//! J. H. Dieterich, Modeling of rock friction, J. Geophys. Res. 84 (1979) 2161; A. Ruina, Slip instability and state
//! variable friction laws, J. Geophys. Res. 88 (1983) 10359; with inertia: J. R. Rice, A. L. Ruina, Stability of steady
//! frictional slipping, J. Appl. Mech. 50 (1983) 343. Dieterich's law of aging with a = 0.010, b = 0.015, as of granite in
//! the laboratory; stress, inertia and distances are chosen here.

use stickslip::model;

model! {
    /// A slider on a spring with Dieterich's rate-and-state friction: Ruina 1983.
    pub struct SpringSlider {
        /// Stretch of the spring.
        state stretch: m = 0.0015;
        /// Logarithm of the speed over V.
        state rate: 1 = 0.1;
        /// Age of the contacts.
        state theta: s = 10.0;
        /// Stiffness over area.
        param k: Pa/m = 4.0e8 where k > 0.0;
        /// Mass over area.
        param mass: kg/m^2 = 1.0e3 where mass > 0.0;
        /// Normal stress.
        param sigma: Pa = 1.0e6 where sigma > 0.0;
        param mu: 1 = 0.6;
        param a: 1 = 0.010 where a > 0.0;
        param b: 1 = 0.015 where b > 0.0;
        /// Slip in which the contacts are renewed.
        param L: m = 1.0e-5 where L > 0.0;
        /// Speed at which the spring is pulled.
        param V: m/s = 1.0e-6 where V > 0.0;
        let speed = V * exp(rate);
        let stress = sigma * (mu + a * rate + b * ln(V * theta / L));
        der(stretch) = V - speed;
        der(rate) = (k * stretch - stress) / (mass * speed);
        der(theta) = 1.0 - speed * theta / L;
    }
}

#[cfg(test)]
mod tests {

    use stickslip::continuation::Kind;

    use super::SpringSlider;
    use crate::asked::{case, close, returns, special};
    use crate::reference::Plant;

    impl Plant<3, 0> for SpringSlider {
        fn rate(&self, _: f64, &[stretch, rate, theta]: &[f64; 3], _: &[f64; 0]) -> [f64; 3] {
            let speed = self.V * rate.exp();
            let coefficient = self.mu + self.a * rate + self.b * (self.V * theta / self.L).ln();
            let force = self.k * stretch - self.sigma * coefficient;
            [
                self.V - speed,
                force / self.mass / speed,
                1.0 - speed * theta / self.L,
            ]
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

    /// Steady sliding is stable above the stiffness σ (b − a)/L, which inertia raises by the factor 1 + m V²/(σ a L); at
    /// it the slider swings with the frequency (V/L) √(b/a − 1).
    #[test]
    fn the_critical_stiffness_is_rices_and_ruinas() {
        for mass in [1e3, 1e9] {
            let model = SpringSlider {
                mass,
                ..SpringSlider::default()
            };
            let inertia = mass * model.V * model.V / (model.sigma * model.a * model.L);
            let expected = model.sigma * (model.b - model.a) / model.L * (1.0 + inertia);
            let (system, case) = case(&model);
            let case = case.following(SpringSlider::k, 3e8..8e8);
            let record = system.equilibria_along(&case);
            let (found, frequency) = special(&record.unwrap(), Kind::Hopf);
            close(found, expected, 1e-9 * expected, "critical stiffness");
            let expected = model.V / model.L * (model.b / model.a - 1.0).sqrt();
            close(frequency, expected, 1e-9, "frequency");
        }
    }

    /// Below it, the slider sticks and slips.
    #[test]
    fn its_earthquakes_are_those_of_a_second_method() {
        let model = SpringSlider {
            mass: 1e9,
            k: 4.8e8,
            ..SpringSlider::default()
        };
        let (system, mut case) = case(&model);
        case.start = Some(vec![0.6e6 / 4.8e8 + 1e-5, 0.0, 10.0]);
        let orbit = system.orbit(&case).unwrap();
        returns(&orbit, &model, 1e-6);
    }
}

//! A drill string as a chain of ten elements with dry friction at the bit.
//!
//! Torque on bit: E. M. Navarro-López, D. Cortés, Avoiding harmful oscillations in a drillstring through dynamical
//! analysis, J. Sound and Vibration 307 (2007) 152, with μ_s = 0.8, μ_c = 0.5, γ_b = 0.9, R_b = 0.1556 m. The string of
//! ten elements, its inertias, stiffness and damping are chosen here; the bit rubs on rock that does not move.

use stickslip::model;
use stickslip_models::friction::BitTorque;

model! {
    /// A drill string of ten elements turned at its top, with friction at the bit only.
    pub struct LongDrillString {
        /// Twist of each element against the table.
        state twist[10]: rad = 0.0;
        /// Speed of each inertia.
        state speed[10]: rad/s = 0.0;
        /// Speed of the rotary table.
        param table: rad/s = 20.0;
        /// Moment of inertia of one element.
        param J: kg*m^2 = 10.0 where J > 0.0;
        /// Moment of inertia of the collars and the bit.
        param J_bit: kg*m^2 = 300.0 where J_bit > 0.0;
        /// Torsional stiffness of one element.
        param k: N*m/rad = 4000.0 where k > 0.0;
        /// Internal damping of one element.
        param c: N*m*s/rad = 10.0 where c >= 0.0;
        /// Mud.
        param mud: N*m*s/rad = 5.0 where mud >= 0.0;
        /// Weight on bit.
        param weight: N = 60000.0 where weight >= 0.0;
        param radius: m = 0.155575 where radius > 0.0;
        friction T: N*m = BitTorque { reach: weight * radius, static_coefficient: 0.8, kinetic_coefficient: 0.5, decay: 0.9, speed: 1.0 } opposing speed[9];
        let torque[0] = -k * twist[0] + c * (table - speed[0]);
        for i in 1..10 {
            let torque[i] = k * (twist[i - 1] - twist[i]) + c * (speed[i - 1] - speed[i]);
        }
        for i in 0..10 {
            der(twist[i]) = speed[i] - table;
        }
        for i in 0..9 {
            der(speed[i]) = (torque[i] - torque[i + 1]) / J;
        }
        der(speed[9]) = (torque[9] + T - mud * speed[9]) / J_bit;
    }
}

#[cfg(test)]
mod tests {
    use std::array::from_fn;

    use stickslip::continuation::Kind;

    use super::LongDrillString;
    use crate::asked::{case, close, returns, special};
    use crate::reference::Plant;

    impl Plant<20, 1> for LongDrillString {
        fn rate(&self, _: f64, y: &[f64; 20], &[friction]: &[f64; 1]) -> [f64; 20] {
            let (twist, speed) = y.split_at(10);
            let above = |i: usize| match i {
                0 => -self.k * twist[0] + self.c * (self.table - speed[0]),
                _ => self.k * (twist[i - 1] - twist[i]) + self.c * (speed[i - 1] - speed[i]),
            };
            from_fn(|i| match i {
                0..10 => speed[i] - self.table,
                10..19 => (above(i - 10) - above(i - 9)) / self.J,
                _ => (above(9) + friction - self.mud * speed[9]) / self.J_bit,
            })
        }
        fn speeds(&self, y: &[f64; 20]) -> [f64; 1] {
            [y[19]]
        }
        fn stick(&self, _: usize, _: &[f64; 20]) -> f64 {
            0.8 * self.weight * self.radius
        }
        fn slip(&self, _: usize, s: f64, _: &[f64; 20]) -> f64 {
            self.weight * self.radius * (0.5 + 0.3 * (-0.9 * s).exp())
        }
    }

    #[test]
    fn its_stick_slip_is_that_of_a_second_method() {
        let model = LongDrillString::default();
        let (system, case) = case(&model);
        let orbit = system.orbit(&case).unwrap();
        let motion = returns(&orbit, &model, 1e-7);
        assert!(motion.word.iter().any(|letter| letter == "s"));
    }

    type Complex = (f64, f64);

    fn times((a, b): Complex, (c, d): Complex) -> Complex {
        (a * c - b * d, a * d + b * c)
    }

    fn over(p: Complex, (c, d): Complex) -> Complex {
        let square = c * c + d * d;
        times(p, (c / square, -d / square))
    }

    /// The torque per twist with which the string answers the bit at the frequency ω: element after element in series.
    fn answer(model: &LongDrillString, omega: f64) -> Complex {
        let element = (model.k, model.c * omega);
        (0..9).fold(element, |above, _| {
            let below = (above.0 - model.J * omega * omega, above.1);
            let sum = (below.0 + element.0, below.1 + element.1);
            over(times(below, element), sum)
        })
    }

    /// Steady drilling loses its stability where the string's answer and the bit's inertia balance, and the fall of the
    /// friction with speed equals all damping.
    #[test]
    fn steady_drilling_loses_stability_where_the_impedances_balance() {
        let model = LongDrillString::default();
        let balance = |omega: f64| answer(&model, omega).0 - model.J_bit * omega * omega;
        let (mut low, mut high) = (0.1, 1.5);
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if balance(middle) > 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        let omega = low;
        let damping = model.mud + answer(&model, omega).1 / omega;
        let table = (0.27 * model.weight * model.radius / damping).ln() / 0.9;
        let (system, case) = case(&model);
        let case = case.following(LongDrillString::table, 20.0..4.0);
        let record = system.equilibria_along(&case);
        let (found, frequency) = special(&record.unwrap(), Kind::Hopf);
        close(found, table, 1e-8 * table, "speed of the table");
        close(frequency, omega, 1e-8, "frequency");
    }
}

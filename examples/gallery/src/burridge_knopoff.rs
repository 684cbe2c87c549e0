//! A fault as a chain of blocks.
//!
//! R. Burridge, L. Knopoff, Model and theoretical seismicity, Bull. Seism. Soc. Am. 57 (1967) 341; nondimensional after
//! J. M. Carlson, J. S. Langer, Mechanical model of an earthquake fault, Phys. Rev. A 40 (1989) 6470, with their friction
//! 1/(1 + 2α s). Ten blocks; speed of the plate, coupling and a limit that grows along the chain are chosen here.

use stickslip::model;
use stickslip_models::friction::Weakening;

model! {
    /// Burridge-Knopoff chain of ten blocks on fixed ground: Carlson and Langer 1989.
    pub struct BurridgeKnopoff {
        /// Lag behind the moving plate.
        state u[10]: 1 = 0.0;
        /// Velocity.
        state v[10]: 1 = 0.0;
        /// Squared stiffness of the coupling springs.
        param l2: 1 = 9.0 where l2 >= 0.0;
        /// Velocity of the plate.
        param nu: 1 = 0.1;
        /// How fast friction weakens.
        param alpha: 1 = 2.0 where alpha >= 0.0;
        /// By how much the friction limit grows from block to block.
        param tilt: 1 = 0.05;
        for i in 0..10 {
            friction F[i]: 1 = Weakening { limit: 1.0 + tilt * i, decay: 2.0 * alpha } opposing v[i];
            der(u[i]) = nu - v[i];
        }
        der(v[0]) = u[0] + l2 * (u[0] - u[1]) + F[0];
        for i in 1..9 {
            der(v[i]) = u[i] + l2 * (2 * u[i] - u[i - 1] - u[i + 1]) + F[i];
        }
        der(v[9]) = u[9] + l2 * (u[9] - u[8]) + F[9];
    }
}

#[cfg(test)]
mod tests {
    use std::array::from_fn;

    use super::BurridgeKnopoff;
    use crate::asked::{case, close};
    use crate::reference::{Plant, follow};

    impl Plant<20, 10> for BurridgeKnopoff {
        fn rate(&self, _: f64, y: &[f64; 20], friction: &[f64; 10]) -> [f64; 20] {
            let lag = |i: usize| y[i];
            let coupled = |i: usize| {
                let left = if i > 0 { lag(i) - lag(i - 1) } else { 0.0 };
                let right = if i < 9 { lag(i) - lag(i + 1) } else { 0.0 };
                lag(i) + self.l2 * (left + right)
            };
            from_fn(|i| match i {
                0..10 => self.nu - y[i + 10],
                _ => coupled(i - 10) + friction[i - 10],
            })
        }
        fn speeds(&self, y: &[f64; 20]) -> [f64; 10] {
            from_fn(|i| y[i + 10])
        }
        fn stick(&self, block: usize, _: &[f64; 20]) -> f64 {
            1.0 + self.tilt * block as f64
        }
        fn slip(&self, block: usize, s: f64, y: &[f64; 20]) -> f64 {
            self.stick(block, y) / (1.0 + 2.0 * self.alpha * s)
        }
    }

    /// Both methods follow the chain from rest for this time.
    #[track_caller]
    fn check(time: f64, tolerance: f64) {
        let model = BurridgeKnopoff::default();
        let (system, case) = case(&model);
        let found = system.motion(&case, time).unwrap();
        let expected = follow(&model, [0.0; 20], (0.0, time), 1e-12);
        let end = found.states.last().unwrap();
        for (j, place) in expected.state.iter().enumerate() {
            close(end[j], *place, tolerance, "where it came to");
            close(found.max[j], expected.max[j], tolerance, "largest value");
        }
    }

    #[test]
    fn the_first_earthquake_is_that_of_a_second_method() {
        check(14.0, 1e-7);
    }

    #[test]
    fn the_fault_goes_on() {
        check(50.0, 1e-5);
    }
}

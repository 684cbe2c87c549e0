//! Two coupled blocks on one belt.
//!
//! U. Galvanetto, S. R. Bishop, L. Briseghella, Mechanical stick-slip vibrations, Int. J. Bifurcation and Chaos 5 (1995)
//! 637; U. Galvanetto, Bifurcations and chaos in a four-dimensional mechanical system with dry-friction, J. Sound and
//! Vibration 204 (1997) 690. Nondimensional with k₁₂ = 1.2, F_s2/F_s1 = 1.3, δ = 3 as published there.

use stickslip::model;
use stickslip_models::friction::Weakening;

model! {
    /// Two coupled blocks on one belt: Galvanetto, Bishop and Briseghella 1995.
    pub struct TwoBlocks {
        state x1: 1 = 0.5;
        state v1: 1 = 0.0;
        state x2: 1 = 1.0;
        state v2: 1 = 0.0;
        /// Stiffness of the coupling spring.
        param coupling: 1 = 1.2 where coupling >= 0.0;
        /// Friction limit of the second block over that of the first.
        param limit: 1 = 1.3 where limit > 0.0;
        /// How fast friction weakens.
        param delta: 1 = 3.0 where delta >= 0.0;
        param belt: 1 = 0.13;
        friction F1: 1 = Weakening { limit: 1.0, decay: delta } opposing v1 - belt;
        friction F2: 1 = Weakening { limit: limit, decay: delta } opposing v2 - belt;
        der(x1) = v1;
        der(v1) = F1 - x1 - coupling * (x1 - x2);
        der(x2) = v2;
        der(v2) = F2 - x2 - coupling * (x2 - x1);
    }
}

#[cfg(test)]
mod tests {
    use super::TwoBlocks;
    use crate::asked::{case, returns};
    use crate::reference::Plant;

    impl Plant<4, 2> for TwoBlocks {
        fn rate(&self, _: f64, &[x1, v1, x2, v2]: &[f64; 4], &[f1, f2]: &[f64; 2]) -> [f64; 4] {
            let pull = self.coupling * (x1 - x2);
            [v1, f1 - x1 - pull, v2, f2 - x2 + pull]
        }
        fn speeds(&self, &[_, v1, _, v2]: &[f64; 4]) -> [f64; 2] {
            [v1 - self.belt, v2 - self.belt]
        }
        fn stick(&self, block: usize, _: &[f64; 4]) -> f64 {
            [1.0, self.limit][block]
        }
        fn slip(&self, block: usize, s: f64, state: &[f64; 4]) -> f64 {
            self.stick(block, state) / (1.0 + self.delta * s)
        }
    }

    #[test]
    fn its_stick_slip_is_that_of_a_second_method() {
        for belt in [0.1, 0.13, 0.25, 0.4] {
            let model = TwoBlocks {
                belt,
                ..TwoBlocks::default()
            };
            let (system, case) = case(&model);
            let orbit = system.orbit(&case).unwrap();
            let tolerance = 1e-8 + 100.0 * orbit.error_estimate;
            returns(&orbit, &model, tolerance);
        }
    }
}

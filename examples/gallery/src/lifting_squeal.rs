//! Squeal that lifts off.
//!
//! N. Hoffmann, M. Fischer, R. Allgaier, L. Gaul, A minimal model for studying properties of the mode-coupling type
//! instability in friction induced oscillations, Mechanics Research Communications 29 (2002) 197. Their block on a belt
//! with k₁₁ = 2, k₁₂ = 1, k₂₂ = 2/3 without the contact and k₃ = 4/3 in it, here with a contact that lets go: load, belt and
//! dampers are chosen so that flutter grows until the block leaves the belt once a period.

use stickslip::model;
use stickslip_models::friction::Coulomb;
use stickslip_models::press::Compliant;

model! {
    /// Mode coupling with a contact that opens: after Hoffmann, Fischer, Allgaier and Gaul 2002.
    pub struct LiftingSqueal {
        /// Displacement along the belt.
        state x: m = 0.0;
        /// Displacement into the belt.
        state y: m = 0.5;
        state vx: m/s = 0.01;
        state vy: m/s = 0.0;
        param m: kg = 1.0 where m > 0.0;
        param k11: N/m = 2.0;
        param k12: N/m = 1.0;
        param k22: N/m = 0.6666666666666666;
        /// Stiffness of the contact.
        param k3: N/m = 1.3333333333333333 where k3 > 0.0;
        param c1: N*s/m = 0.05 where c1 >= 0.0;
        param c2: N*s/m = 0.05 where c2 >= 0.0;
        /// What pushes the block into the belt.
        param load: N = 1.0 where load > 0.0;
        param mu: 1 = 0.9 where mu >= 0.0;
        param belt: m/s = 1.0 where belt > 0.0;
        press N: N = Compliant { stiffness: k3, damping: 0.0 } closing -y;
        friction F: N = Coulomb { level: mu * N } opposing vx - belt;
        der(x) = vx;
        der(y) = vy;
        der(vx) = (F - k11 * x - k12 * y - c1 * vx) / m;
        der(vy) = (load - N - k12 * x - k22 * y - c2 * vy) / m;
    }
}

#[cfg(test)]
mod tests {

    use stickslip::study::Kind;

    use super::LiftingSqueal;
    use crate::asked::{case, close, returns, special};
    use crate::reference::Plant;

    impl Plant<4, 1> for LiftingSqueal {
        fn rate(&self, _: f64, &[x, y, vx, vy]: &[f64; 4], &[friction]: &[f64; 1]) -> [f64; 4] {
            let pulled = self.k11 * x + self.k12 * y + self.c1 * vx;
            let pressed = self.k12 * x + self.k22 * y + self.c2 * vy + self.k3 * y.max(0.0);
            [
                vx,
                vy,
                (friction - pulled) / self.m,
                (self.load - pressed) / self.m,
            ]
        }
        fn speeds(&self, &[_, _, vx, _]: &[f64; 4]) -> [f64; 1] {
            [vx - self.belt]
        }
        fn stick(&self, _: usize, &[_, y, _, _]: &[f64; 4]) -> f64 {
            self.mu * self.k3 * y.max(0.0)
        }
        fn slip(&self, contact: usize, _: f64, state: &[f64; 4]) -> f64 {
            self.stick(contact, state)
        }
    }

    #[test]
    fn the_block_leaves_the_belt_once_a_period() {
        let model = LiftingSqueal::default();
        let (system, case) = case(&model);
        let orbit = system.orbit(&case).unwrap();
        assert_eq!(orbit.word.as_deref(), Some("close(N) open(N)"));
        let motion = returns(&orbit, &model, 1e-8);
        assert_eq!(motion.word, ["-"]);
        assert!(motion.min[1] < 0.0, "the contact never opens");
    }

    /// A load moves the equilibrium alone: flutter begins as without one, at μ = (3/4)(1 + 2 c₁ c₂).
    #[test]
    fn flutter_knows_no_load() {
        for load in [0.1, 1.0, 10.0] {
            let (system, case) = case(&LiftingSqueal {
                load,
                ..LiftingSqueal::default()
            });
            let case = case.following(LiftingSqueal::mu, 0.5..0.9);
            let record = system.equilibria_along(&case);
            let (mu, _) = special(&record.unwrap(), Kind::Hopf);
            close(mu, 0.75 * (1.0 + 2.0 * 0.05 * 0.05), 1e-9, "threshold");
        }
    }
}

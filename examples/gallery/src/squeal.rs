//! Mode-coupling squeal.
//!
//! N. Hoffmann, M. Fischer, R. Allgaier, L. Gaul, A minimal model for studying properties of the mode-coupling type
//! instability in friction induced oscillations, Mechanics Research Communications 29 (2002) 197.
//!
//! A block on a belt hangs in two oblique springs; its contact spring presses on the belt, and what it presses drags.
//! The stiffness matrix is that of the publication, with k₁₁ = k₂₂ = 2, k₁₂ = 1, k₃ = 4/3. Preload, speed of the belt
//! and dampers are chosen here: they bring the limit cycle into the range in which the contact never opens.

use stickslip::model;
use stickslip_models::friction::Coulomb;

model! {
    /// Mode coupling: Hoffmann, Fischer, Allgaier and Gaul 2002.
    pub struct Squeal {
        /// Displacement along the belt.
        state x: m = 0.3;
        /// Displacement into the belt.
        state y: m = -0.2;
        state vx: m/s = 0.0;
        state vy: m/s = 0.0;
        param m: kg = 1.0 where m > 0.0;
        param k11: N/m = 2.0;
        param k12: N/m = 1.0;
        /// Normal stiffness, that of the contact included.
        param k22: N/m = 2.0;
        /// Stiffness of the contact.
        param k3: N/m = 1.3333333333333333 where k3 > 0.0;
        param c1: N*s/m = 0.1 where c1 >= 0.0;
        param c2: N*s/m = 0.1 where c2 >= 0.0;
        param preload: N = 1.0 where preload > 0.0;
        param mu: 1 = 0.85 where mu >= 0.0;
        param belt: m/s = 0.05 where belt > 0.0;
        let normal = preload + k3 * y;
        friction F: N = Coulomb { level: mu * normal } opposing vx - belt;
        der(x) = vx;
        der(y) = vy;
        der(vx) = (F - k11 * x - k12 * y - c1 * vx) / m;
        der(vy) = (-k12 * x - k22 * y - c2 * vy) / m;
    }
}

#[cfg(test)]
mod tests {

    use stickslip::continuation::Kind;
    use stickslip::study::EquilibriaRecord;

    use super::Squeal;
    use crate::asked::{case, close, returns, special};
    use crate::reference::Plant;

    impl Plant<4, 1> for Squeal {
        fn rate(&self, _: f64, &[x, y, vx, vy]: &[f64; 4], &[friction]: &[f64; 1]) -> [f64; 4] {
            let pulled = self.k11 * x + self.k12 * y + self.c1 * vx;
            let pressed = self.k12 * x + self.k22 * y + self.c2 * vy;
            [vx, vy, (friction - pulled) / self.m, -pressed / self.m]
        }
        fn speeds(&self, &[_, _, vx, _]: &[f64; 4]) -> [f64; 1] {
            [vx - self.belt]
        }
        fn stick(&self, _: usize, &[_, y, _, _]: &[f64; 4]) -> f64 {
            self.mu * (self.preload + self.k3 * y)
        }
        fn slip(&self, contact: usize, _: f64, state: &[f64; 4]) -> f64 {
            self.stick(contact, state)
        }
    }

    fn equilibria(model: &Squeal) -> EquilibriaRecord {
        let (system, case) = case(model);
        let case = case.following(Squeal::mu, 0.0..1.2);
        let record = system.equilibria_along(&case);
        record.unwrap()
    }

    /// Flutter of the symmetric model begins at μ = (3/4)(1 + 2 c₁ c₂) with the frequency √2.
    #[test]
    fn flutter_begins_where_the_closed_form_says() {
        for (c1, c2) in [(0.1, 0.1), (0.2, 0.1), (0.01, 0.3)] {
            let record = equilibria(&Squeal {
                c1,
                c2,
                ..Squeal::default()
            });
            let (mu, frequency) = special(&record, Kind::Hopf);
            close(mu, 0.75 * (1.0 + 2.0 * c1 * c2), 1e-9, "threshold");
            close(frequency, 2.0_f64.sqrt(), 1e-9, "frequency");
        }
    }

    /// Without dampers both pairs of eigenvalues meet on the imaginary axis at μ = 3/4.
    #[test]
    fn undamped_flutter_begins_at_three_quarters() {
        let record = equilibria(&Squeal {
            c1: 0.0,
            c2: 0.0,
            ..Squeal::default()
        });
        assert_eq!(record.ended.word(), "reached-end");
        let [flutter] = record.special.as_slice() else {
            panic!("{:?}", record.special)
        };
        close(flutter.r, 0.75, 1e-9, "threshold");
    }

    /// The contact presses all the while.
    #[test]
    fn the_squeal_is_that_of_a_second_method() {
        let model = Squeal::default();
        let (system, case) = case(&model);
        let orbit = system.orbit(&case).unwrap();
        let motion = returns(&orbit, &model, 1e-8);
        assert_eq!(motion.word, ["-", "s", "-"]);
        assert!(
            model.preload + model.k3 * motion.min[1] > 0.0,
            "the contact opens"
        );
    }
}

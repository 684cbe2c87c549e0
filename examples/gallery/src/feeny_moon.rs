//! A forced oscillator whose normal load grows with its displacement.
//!
//! B. F. Feeny, F. C. Moon, Chaos in a forced dry-friction oscillator: experiments and numerical modelling, J. Sound and
//! Vibration 170 (1994) 303; B. Feeny, A nonsmooth Coulomb friction oscillator, Physica D 59 (1992) 25. There the normal
//! load is 1 + 1.5 x while that is positive, Ω = 1.25 and a = 1.9. The force is smaller here, so that the contact
//! does not open: an opening contact cannot be declared.

use stickslip::model;
use stickslip_models::friction::Coulomb;

model! {
    /// A forced oscillator under a normal load that grows with displacement: Feeny and Moon 1994.
    pub struct FeenyMoon {
        state x: 1 = 0.0;
        state v: 1 = 0.0;
        param zeta: 1 = 0.0 where zeta >= 0.0;
        /// How fast the load grows with the displacement.
        param growth: 1 = 1.5 where growth >= 0.0;
        /// Amplitude of the force.
        param force: 1 = 1.2;
        param Omega: 1 = 1.25 where Omega > 0.0;
        drive phi at Omega;
        friction F: 1 = Coulomb { level: 1.0 + growth * x } opposing v;
        der(x) = v;
        der(v) = force * cos(phi) - 2 * zeta * v - x + F;
    }
}

#[cfg(test)]
mod tests {
    use super::FeenyMoon;
    use crate::asked::{case, returns};
    use crate::reference::Plant;

    impl Plant<2, 1> for FeenyMoon {
        fn rate(&self, t: f64, &[x, v]: &[f64; 2], &[friction]: &[f64; 1]) -> [f64; 2] {
            let force = self.force * (self.Omega * t).cos();
            [v, force - 2.0 * self.zeta * v - x + friction]
        }
        fn speeds(&self, &[_, v]: &[f64; 2]) -> [f64; 1] {
            [v]
        }
        fn stick(&self, _: usize, &[x, _]: &[f64; 2]) -> f64 {
            1.0 + self.growth * x
        }
        fn slip(&self, contact: usize, _: f64, y: &[f64; 2]) -> f64 {
            self.stick(contact, y)
        }
    }

    #[test]
    fn its_response_is_that_of_a_second_method() {
        for force in [1.1, 1.2, 1.3] {
            let model = FeenyMoon {
                force,
                ..FeenyMoon::default()
            };
            let (system, case) = case(&model);
            let motion = returns(&system.orbit(&case).unwrap(), &model, 1e-8);
            assert!(
                1.0 + model.growth * motion.min[0] > 0.0,
                "the contact opens"
            );
        }
    }
}

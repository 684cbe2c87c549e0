//! Froude's pendulum.
//!
//! W. Froude, as told by Lord Rayleigh, The Theory of Sound I (1877) §68: a pendulum that hangs on a turning shaft swings
//! by itself where friction falls with speed. Values chosen here.

use stickslip::model;
use stickslip_models::friction::Tustin;

model! {
    /// A pendulum on a turning shaft: Froude, after Rayleigh 1877.
    pub struct FroudePendulum {
        state angle: rad = 0.0;
        state speed: rad/s = 0.0;
        param J: kg*m^2 = 0.02 where J > 0.0;
        /// Weight times length.
        param moment: N*m = 0.5 where moment > 0.0;
        /// Drag of the air.
        param drag: N*m*s/rad = 0.005 where drag >= 0.0;
        /// Speed of the shaft.
        param shaft: rad/s = 3.0;
        /// Torque at rest.
        param grip: N*m = 0.1 where grip >= 0.0;
        friction M: N*m = Tustin { static_level: grip, kinetic_level: 0.6 * grip, speed: 4.0, viscous: 0.0 } opposing speed - shaft;
        der(angle) = speed;
        der(speed) = (M - drag * speed - moment * sin(angle)) / J;
    }
}

#[cfg(test)]
mod tests {

    use stickslip::continuation::Kind;

    use super::FroudePendulum;
    use crate::asked::{case, close, returns, special};
    use crate::reference::Plant;

    impl Plant<2, 1> for FroudePendulum {
        fn rate(&self, _: f64, &[angle, speed]: &[f64; 2], &[friction]: &[f64; 1]) -> [f64; 2] {
            let torque = friction - self.drag * speed - self.moment * angle.sin();
            [speed, torque / self.J]
        }
        fn speeds(&self, &[_, speed]: &[f64; 2]) -> [f64; 1] {
            [speed - self.shaft]
        }
        fn stick(&self, _: usize, _: &[f64; 2]) -> f64 {
            self.grip
        }
        fn slip(&self, _: usize, s: f64, _: &[f64; 2]) -> f64 {
            self.grip * (0.6 + 0.4 * (-s / 4.0).exp())
        }
    }

    /// Rayleigh: the pendulum hangs at rest, drawn aside, where the drag outweighs the fall of friction with speed; both
    /// balance at the speed 4 ln(0.1 grip/drag) of the shaft.
    #[test]
    fn it_hangs_still_above_a_speed_that_is_a_closed_form() {
        let model = FroudePendulum::default();
        let (system, case) = case(&model);
        let case = case.following(FroudePendulum::shaft, 0.5..6.0);
        let record = system.equilibria_along(&case);
        let (shaft, frequency) = special(&record.unwrap(), Kind::Hopf);
        let expected = 4.0 * (0.1 * model.grip / model.drag).ln();
        let aside = (model.slip(0, expected, &[0.0; 2]) / model.moment).asin();
        let natural = (model.moment * aside.cos() / model.J).sqrt();
        close(shaft, expected, 1e-9, "speed of the shaft");
        close(frequency, natural, 1e-9 * natural, "frequency");
    }

    #[test]
    fn its_swing_is_that_of_a_second_method() {
        for shaft in [0.5, 1.0, 2.0] {
            let model = FroudePendulum {
                shaft,
                ..FroudePendulum::default()
            };
            let (system, case) = case(&model);
            returns(&system.orbit(&case).unwrap(), &model, 1e-8);
        }
    }
}

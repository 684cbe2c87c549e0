//! A clutch that is closed under load.
//!
//! A. Crowther, N. Zhang, D. K. Liu, J. K. Jeyakumaran, Analysis and simulation of clutch engagement judder and stick-slip
//! in automotive powertrain systems, Proc. IMechE D 218 (2004) 1427: inertias of engine, disc and vehicle with a
//! compliant driveline, a friction coefficient that falls with the slip. Reduced to three inertias, values chosen here.

use stickslip::model;
use stickslip_models::friction::Tustin;

model! {
    /// A clutch between engine and disc, with a compliant driveline to the vehicle: Crowther, Zhang, Liu and Jeyakumaran 2004.
    pub struct Clutch {
        state engine: rad/s = 100.0;
        state disc: rad/s = 0.0;
        state vehicle: rad/s = 0.0;
        /// Twist of the driveline.
        state twist: rad = 0.0;
        param J_engine: kg*m^2 = 0.2 where J_engine > 0.0;
        param J_disc: kg*m^2 = 0.05 where J_disc > 0.0;
        param J_vehicle: kg*m^2 = 1.5 where J_vehicle > 0.0;
        param k: N*m/rad = 800.0 where k > 0.0;
        param c: N*m*s/rad = 2.0 where c >= 0.0;
        /// Torque of the engine.
        param driving: N*m = 100.0;
        /// Torque of the road.
        param load: N*m = 20.0;
        /// Torque that the clutch carries at rest.
        param capacity: N*m = 180.0 where capacity >= 0.0;
        friction T: N*m = Tustin { static_level: capacity, kinetic_level: 0.8 * capacity, speed: 5.0, viscous: 0.0 } opposing engine - disc;
        let shaft = k * twist + c * (disc - vehicle);
        der(engine) = (driving + T) / J_engine;
        der(disc) = (-T - shaft) / J_disc;
        der(vehicle) = (shaft - load) / J_vehicle;
        der(twist) = disc - vehicle;
    }
}

#[cfg(test)]
mod tests {
    use super::Clutch;
    use crate::asked::{case, close};
    use crate::reference::{Plant, follow};

    impl Plant<4, 1> for Clutch {
        fn rate(&self, _: f64, y: &[f64; 4], &[friction]: &[f64; 1]) -> [f64; 4] {
            let &[_, disc, vehicle, twist] = y;
            let shaft = self.k * twist + self.c * (disc - vehicle);
            [
                (self.driving + friction) / self.J_engine,
                (-friction - shaft) / self.J_disc,
                (shaft - self.load) / self.J_vehicle,
                disc - vehicle,
            ]
        }
        fn speeds(&self, &[engine, disc, _, _]: &[f64; 4]) -> [f64; 1] {
            [engine - disc]
        }
        fn stick(&self, _: usize, _: &[f64; 4]) -> f64 {
            self.capacity
        }
        fn slip(&self, _: usize, s: f64, _: &[f64; 4]) -> f64 {
            self.capacity * (0.8 + 0.2 * (-s / 5.0).exp())
        }
    }

    #[test]
    fn closing_it_is_as_by_a_second_method() {
        for capacity in [180.0, 130.0] {
            let model = Clutch {
                capacity,
                ..Clutch::default()
            };
            let (system, case) = case(&model);
            for time in [0.1, 0.5, 2.0] {
                let found = system.motion(&case, time).unwrap();
                let expected = follow(&model, [100.0, 0.0, 0.0, 0.0], (0.0, time), 1e-12);
                let end = found.states.last().unwrap();
                for (j, scale) in [100.0, 100.0, 100.0, 0.1].into_iter().enumerate() {
                    close(end[j], expected.state[j], 1e-8 * scale, "where it came to");
                    close(found.max[j], expected.max[j], 1e-8 * scale, "largest value");
                }
            }
        }
    }

    /// Friction inside changes no momentum; once all turn together, the clutch carries what the rest needs.
    #[test]
    fn momentum_is_kept_and_the_locked_clutch_carries_the_vehicle() {
        let (model, time) = (Clutch::default(), 20.0);
        let (system, case) = case(&model);
        let motion = system.motion(&case, time).unwrap();
        let end = motion.states.last().unwrap();
        let inertias = [model.J_engine, model.J_disc, model.J_vehicle];
        let momentum: f64 = inertias.iter().zip(end).map(|(j, speed)| j * speed).sum();
        let expected = model.J_engine * 100.0 + (model.driving - model.load) * time;
        close(momentum, expected, 1e-8 * expected, "momentum");
        let acceleration = (model.driving - model.load) / inertias.iter().sum::<f64>();
        let torque = model.J_engine * acceleration - model.driving;
        close(motion.forces.last().unwrap()[0], torque, 1e-6, "torque");
    }
}

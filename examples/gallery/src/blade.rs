//! A turbine blade with a friction damper under its platform.
//!
//! J. H. Griffin, Friction damping of resonant stresses in gas turbine engine airfoils, ASME J. Eng. for Power 102 (1980)
//! 329: a blade with a damper of stiffness k_d that slips at a force. Two masses instead of one, values chosen here.

use stickslip::model;
use stickslip_models::friction::Jenkins;

model! {
    /// A turbine blade of two masses with an underplatform damper at the inner one: Griffin 1980.
    pub struct Blade {
        state x1: m = 0.0;
        state x2: m = 0.0;
        state v1: m/s = 0.0;
        state v2: m/s = 0.0;
        /// Force in the damper.
        state z: N = 0.0;
        param m1: kg = 1.0 where m1 > 0.0;
        param m2: kg = 1.0 where m2 > 0.0;
        param k1: N/m = 1.0 where k1 > 0.0;
        param k2: N/m = 1.0 where k2 > 0.0;
        param c: N*s/m = 0.02 where c >= 0.0;
        /// Stiffness of the damper.
        param kd: N/m = 0.5 where kd > 0.0;
        /// Force at which the damper slips.
        param level: N = 0.05 where level > 0.0;
        /// Amplitude of the force on the outer mass.
        param load: N = 0.1;
        param omega: rad/s = 0.6 where omega > 0.0;
        drive phi at omega;
        friction F: N = Jenkins { stiffness: kd, level: level } opposing v1 with z;
        der(x1) = v1;
        der(x2) = v2;
        der(v1) = (F - k1 * x1 - c * v1 - k2 * (x1 - x2) - c * (v1 - v2)) / m1;
        der(v2) = (-k2 * (x2 - x1) - c * (v2 - v1) + load * cos(phi)) / m2;
    }
}

#[cfg(test)]
mod tests {

    use super::Blade;
    use crate::asked::{case, close, returns};
    use crate::reference::Plant;

    impl Plant<5, 1> for Blade {
        fn rate(&self, t: f64, y: &[f64; 5], &[friction]: &[f64; 1]) -> [f64; 5] {
            let &[x1, x2, v1, v2, _] = y;
            let between = self.k2 * (x1 - x2) + self.c * (v1 - v2);
            let inner = friction - self.k1 * x1 - self.c * v1 - between;
            let outer = between + self.load * (self.omega * t).cos();
            [v1, v2, inner / self.m1, outer / self.m2, self.kd * v1]
        }
        fn speeds(&self, &[_, _, v1, _, _]: &[f64; 5]) -> [f64; 1] {
            [v1]
        }
        fn stick(&self, _: usize, _: &[f64; 5]) -> f64 {
            self.level
        }
        fn slip(&self, _: usize, _: f64, _: &[f64; 5]) -> f64 {
            self.level
        }
        fn elastic(&self, _: usize, &[.., z]: &[f64; 5]) -> Option<f64> {
            Some(-z)
        }
        fn sliding(&self, mut rate: [f64; 5], [slips]: [bool; 1]) -> [f64; 5] {
            if slips {
                rate[4] = 0.0;
            }
            rate
        }
    }

    #[test]
    fn the_damped_response_is_that_of_a_second_method() {
        for omega in [0.5, 0.6, 0.66] {
            let model = Blade {
                omega,
                ..Blade::default()
            };
            let (system, case) = case(&model);
            let orbit = system.orbit(&case).unwrap();
            let motion = returns(&orbit, &model, 1e-8);
            assert!(motion.word.len() > 2, "the damper slips: {:?}", motion.word);
        }
    }

    /// Amplitude of the inner mass where the damper is a spring: two coupled linear oscillators.
    fn stuck(model: &Blade) -> f64 {
        let omega = model.omega;
        let damping = model.c * omega;
        let inner = (
            model.k1 + model.kd + model.k2 - model.m1 * omega * omega,
            2.0 * damping,
        );
        let outer = (model.k2 - model.m2 * omega * omega, damping);
        let between = (model.k2, damping);
        let real = inner.0 * outer.0 - inner.1 * outer.1 - between.0.powi(2) + between.1.powi(2);
        let imaginary = inner.0 * outer.1 + inner.1 * outer.0 - 2.0 * between.0 * between.1;
        model.load * between.0.hypot(between.1) / real.hypot(imaginary)
    }

    /// From rest, a damper that never slips is a spring: the motion settles on the linear response.
    #[test]
    fn a_stuck_damper_is_a_spring() {
        let model = Blade {
            level: 5.0,
            omega: 0.9,
            ..Blade::default()
        };
        let (system, mut case) = case(&model);
        let settled = system.motion(&case, 8000.0).unwrap();
        case.start = settled.states.last().cloned();
        let period = std::f64::consts::TAU / model.omega;
        let response = system.motion(&case, period).unwrap();
        let (expected, found) = (stuck(&model), response.max[0]);
        close(found, expected, 1e-8 * expected, "amplitude");
    }

    /// The same as an orbit, at several frequencies: the damper's preload is free, the amplitude is not.
    #[test]
    fn the_stuck_response_is_an_orbit() {
        for omega in [0.4, 0.7, 0.9, 1.3, 2.2] {
            let model = Blade {
                level: 5.0,
                omega,
                ..Blade::default()
            };
            let (system, case) = case(&model);
            let orbit = system.orbit(&case).unwrap();
            let (expected, found) = (stuck(&model), 0.5 * (orbit.max[0] - orbit.min[0]));
            close(found, expected, 1e-9 * expected, "amplitude");
        }
    }

    /// The whole response at loads under which the damper slips everywhere, near the resonances, once, and never: through
    /// stretches in which its preload is free.
    #[test]
    fn the_response_is_followed_through_the_stuck_regime() {
        for level in [0.01, 0.05, 0.2, 5.0] {
            let model = Blade {
                level,
                ..Blade::default()
            };
            let (system, mut case) = case(&model);
            case.accuracy = 1e-11;
            let case = case.following(Blade::omega, 0.4..2.2);
            let record = system.branch(&case);
            let record = record.unwrap();
            assert_eq!(record.ended.word(), "reached-end");
            assert!(record.special.is_empty(), "{level}: {:?}", record.special);
            let mut stays = 0;
            for orbit in &record.points {
                let omega = orbit.r.unwrap();
                let linear = stuck(&Blade { omega, ..model });
                if model.kd * linear < model.level {
                    let found = 0.5 * (orbit.max[0] - orbit.min[0]);
                    close(found, linear, 1e-9 * linear, "amplitude");
                    assert_eq!(orbit.held.len(), 1, "its preload is free");
                    stays += 1;
                }
            }
            assert!(stays > 2 && (level > 1.0 || stays < record.points.len()));
            for orbit in record.points.iter().step_by(record.points.len() / 10) {
                let omega = orbit.r.unwrap();
                returns(orbit, &Blade { omega, ..model }, 1e-8);
            }
        }
    }
}

//! A chain with joints that slip, springs that stiffen and a stop.
//!
//! Example 07 of NLvib (M. Krack, J. Gross, Harmonic Balance for Nonlinear Vibration Problems, Springer 2019): three masses
//! between two walls, all of its elements at once. Its folds bound a range of frequencies with two stable responses.

use stickslip::model;
use stickslip_models::friction::Jenkins;
use stickslip_models::press::Compliant;

model! {
    /// Three masses with two Jenkins elements, cubic springs and a one-sided one: example 07 of NLvib.
    pub struct JointedChain {
        state x[3] = 0.0;
        state v[3] = 0.0;
        /// Force of the joint of the first mass with the ground.
        state ground = 0.0;
        /// Force of the joint between the first and the second mass.
        state between = 0.0;
        param k = 1.0 where k > 0.0;
        /// Damping over stiffness.
        param damping = 0.02 where damping >= 0.0;
        /// Stiffness of the joints.
        param joint = 20.0 where joint > 0.0;
        /// Force at which they slip.
        param level = 1.0 where level > 0.0;
        param cubic = 1.0;
        param stop = 1.0 where stop > 0.0;
        param gap = 0.25;
        param load = 1.0;
        param omega = 1.2 where omega > 0.0;
        drive phi at omega;
        friction F = Jenkins { stiffness: joint, level } opposing v[0] with ground;
        friction G = Jenkins { stiffness: joint, level } opposing v[1] - v[0] with between;
        press N = Compliant { stiffness: stop, damping: 0.0 } closing gap - x[2];
        let first = k * (x[0] + damping * v[0]);
        let second = k * (x[1] - x[0] + damping * (v[1] - v[0]));
        let third = k * (x[2] - x[1] + damping * (v[2] - v[1])) + cubic * powi(x[2] - x[1], 3);
        let last = k * (x[2] + damping * v[2]);
        for i in 0..3 {
            der(x[i]) = v[i];
        }
        der(v[0]) = second - first + F - G;
        der(v[1]) = third - second - cubic * powi(x[1], 3) + load * cos(phi) + G;
        der(v[2]) = -third - last - N;
    }
}

#[cfg(test)]
mod tests {

    use stickslip::study::{Case, Dynamics, Kind, System};

    use super::JointedChain;
    use crate::asked::{case, close};
    use crate::balance::{Balance, Balanced, slider};

    impl Balanced<3> for JointedChain {
        fn stiffness(&self, order: usize) -> [[[f64; 2]; 3]; 3] {
            let frequency = order as f64 * self.omega;
            let entry = |i: usize, j: usize| match i.abs_diff(j) {
                0 => [
                    2.0 * self.k - frequency * frequency,
                    2.0 * self.k * self.damping * frequency,
                ],
                1 => [-self.k, -self.k * self.damping * frequency],
                _ => [0.0; 2],
            };
            std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
        }
        fn load(&self, order: usize) -> [[f64; 2]; 3] {
            let load = if order == 1 { self.load } else { 0.0 };
            [[0.0; 2], [load, 0.0], [0.0; 2]]
        }
        fn forces(&self, motion: &[[f64; 3]]) -> Vec<[f64; 3]> {
            let slider = |stretch: fn(&[f64; 3]) -> f64| {
                slider(motion.iter().map(stretch), self.joint, self.level)
            };
            let (ground, between) = (slider(|[x, ..]| *x), slider(|[x, y, _]| y - x));
            let joints = ground.iter().zip(&between);
            let at = |([_, y, z], (ground, between)): (&[f64; 3], (&f64, &f64))| {
                let stiffening = self.cubic * (z - y).powi(3);
                let stop = self.stop * (z - self.gap).max(0.0);
                [
                    between - ground,
                    stiffening - between - self.cubic * y.powi(3),
                    -stiffening - stop,
                ]
            };
            motion.iter().zip(joints).map(at).collect()
        }
    }

    /// Its stop is rounded, as the exact dynamics know no joints that stop: over 1e-4 of its gap.
    fn asked(omega: f64) -> (System, Case) {
        let model = JointedChain {
            omega,
            ..JointedChain::default()
        };
        let (system, case) = case(&model);
        let dynamics = Dynamics::Smoothed("cubic:1e4".parse().unwrap());
        (system, Case { dynamics, ..case })
    }

    /// Seven harmonics miss up to a few thousandths of what the third mass moves, and next to the fold a hundredth. Below, where
    /// joints stick all along, their preload is free, and each method finds another one.
    #[test]
    fn the_response_is_that_of_a_harmonic_balance() {
        let mut motion = Balance::rest(0..=7, 1024);
        for omega in [
            0.5, 0.625, 0.75, 0.875, 1.0, 1.125, 1.25, 1.375, 1.5, 1.56, 1.6, 1.62,
        ] {
            let model = JointedChain {
                omega,
                ..JointedChain::default()
            };
            motion = motion.solved(&model, 1e-9).expect("a balance");
            if omega < 1.25 {
                continue;
            }
            let (system, case) = asked(omega);
            let orbit = system
                .orbit(&Case {
                    start: start(&motion, &model),
                    ..case
                })
                .unwrap();
            let samples = motion.motion();
            for j in 0..3 {
                let most = |way: f64| {
                    samples
                        .iter()
                        .map(|at| way * at[j])
                        .fold(f64::MIN, f64::max)
                };
                let tolerance = if omega < 1.58 { 5e-3 } else { 2e-2 } * orbit.max_abs[2];
                close(orbit.max[j], most(1.0), tolerance, "largest displacement");
                close(
                    orbit.min[j],
                    -most(-1.0),
                    tolerance,
                    "smallest displacement",
                );
            }
            assert_eq!(orbit.floquet.stability.name(), "stable");
        }
    }

    /// Where the joint between the masses sticks all along, it swings about the middle of its bounds; at 1.6259934 another of
    /// its maxima becomes the largest, and the branch turns there at a corner, r coming back.
    #[test]
    fn the_branch_goes_around_where_another_maximum_is_the_largest() {
        for (from, accuracy) in [(1.5, 1e-6), (1.55, 1e-7), (1.55, 1e-8)] {
            let (system, case) = asked(from);
            let case = Case { accuracy, ..case };
            let branch = system.branch(&case.following(JointedChain::omega, from..1.65));
            let branch = branch.unwrap();
            let folds: Vec<f64> = branch.special.iter().map(|one| one.r).collect();
            assert_eq!(folds.len(), 2, "{folds:?}");
            close(folds[0], 1.627818507, 1e-6, "the resonance's fold");
            close(folds[1], 1.626875714, 1e-6, "the fold beyond");
            assert_eq!(branch.points.last().unwrap().r, Some(1.65));
        }
    }

    /// Where the balanced motion begins.
    fn start(motion: &Balance<3>, model: &JointedChain) -> Option<Vec<f64>> {
        let place = motion.motion()[0];
        let speed = |j: usize| motion.speed(j) * model.omega;
        let joints = [place[0], place[1] - place[0]]
            .map(|x| (model.joint * x).clamp(-model.level, model.level));
        let all = place.into_iter().chain((0..3).map(speed)).chain(joints);
        Some(all.chain([0.0]).collect())
    }

    #[test]
    fn its_resonance_ends_in_a_fold() {
        let (system, case) = asked(1.5);
        let branch = system
            .branch(
                &Case {
                    accuracy: 1e-6,
                    ..case
                }
                .following(JointedChain::omega, 1.5..1.7),
            )
            .unwrap();
        let fold = &branch.special[0];
        assert_eq!(fold.kind, Kind::Fold);
        let stable = |place: usize| branch.points[place].floquet.stability.name();
        assert_eq!(
            [stable(fold.after - 1), stable(fold.after)],
            ["stable", "unstable"]
        );
        close(fold.r, 1.6278, 1e-4, "fold");
    }
}

//! A ball on a table that moves up and down.
//!
//! P. J. Holmes, The dynamics of repeated impacts with a sinusoidally vibrating table, J. Sound and Vibration 84 (1982)
//! 173. Time in 1/ω, lengths in g/ω². The ball keeps time with the table, n turns a flight, from Γ = n π (1 − e)/(1 + e) on;
//! below, its bounces pile up and it rests on the table, until that falls faster than the ball would: sin φ = 1/Γ.

use stickslip::model;
use stickslip_models::press::Rigid;

model! {
    /// A ball that bounces on a vibrating table: Holmes 1982.
    pub struct BouncingBall {
        state y = 1.0;
        state v = 0.0;
        /// Largest acceleration of the table over that of gravity.
        param gamma = 1.2 where gamma >= 0.0;
        /// Coefficient of restitution.
        param e = 0.3 where 0.0 <= e <= 1.0;
        drive phi at 1.0;
        press R = Rigid { restitution: e } closing y - gamma * sin(phi);
        der(y) = v;
        der(v) = R - 1.0;
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};
    use std::ops::ControlFlow;

    use stickslip::continuation::Kind;

    use super::BouncingBall;
    use crate::asked::{along, case, close};

    #[test]
    fn it_keeps_time_in_a_window() {
        for e in [0.8, 0.5, 0.3] {
            let born = PI * (1.0 - e) / (1.0 + e);
            let flips = born.hypot(2.0 * (1.0 + e * e) / ((1.0 + e) * (1.0 + e)));
            let gamma = 0.5 * (born + flips);
            let phase = (born / gamma).acos();
            let (system, mut case) = case(&BouncingBall { gamma, e });
            let height = gamma * phase.sin() + PI * phase - 0.5 * phase * phase;
            case.start = Some(vec![height, phase - PI, 0.0]);
            for (to, kind, closed) in [
                (1.1 * flips, Kind::Flip, flips),
                (0.9 * born, Kind::Fold, born),
            ] {
                let case = along(&case, BouncingBall::gamma, gamma, to);
                let branch = system.branch(&case, &mut |_| ControlFlow::Continue(()));
                let branch = branch.unwrap();
                let found = branch.special.iter().find(|one| one.kind == kind);
                close(found.unwrap().r, closed, 1e-9, kind.name());
            }
        }
    }

    #[test]
    fn below_it_the_ball_comes_to_rest_every_turn() {
        let (system, case) = case(&BouncingBall::default());
        let orbit = system.orbit(&case).unwrap();
        assert_eq!(orbit.word.as_deref(), Some("impact(R) rest(R) open(R)"));
        close(orbit.period, TAU, 1e-12, "period");
        assert!(
            orbit
                .floquet
                .multipliers
                .iter()
                .all(|one| one.norm() == 0.0)
        );
    }
}

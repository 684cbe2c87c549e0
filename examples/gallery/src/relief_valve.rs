//! A pressure relief valve that chatters.
//!
//! C. J. Hős, A. R. Champneys, Grazing bifurcations and chatter in a pressure relief valve model, Physica D 241 (2012)
//! 2068. The inflow q is the design variable: steady outflow loses its stability, and as q falls further the disc begins to
//! hit its seat.

use stickslip::model;
use stickslip_models::press::Rigid;

model! {
    /// A relief valve before a vessel: Hős and Champneys 2012.
    pub struct ReliefValve {
        /// Lift of the disc.
        state y = 2.4;
        state v = 0.0;
        /// Pressure in the vessel.
        state p = 12.4;
        /// Damping.
        param kappa = 1.25 where kappa >= 0.0;
        /// Precompression of the spring.
        param delta = 10.0;
        /// Stiffness of the vessel.
        param beta = 20.0 where beta > 0.0;
        /// Inflow.
        param q = 9.0 where q >= 0.0;
        /// Coefficient of restitution.
        param r = 0.8 where 0.0 <= r <= 1.0;
        press R = Rigid { restitution: r } closing y;
        der(y) = v;
        der(v) = -kappa * v - (y + delta) + p + R;
        der(p) = beta * (q - y * sqrt(p));
    }
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;

    use stickslip::continuation::Kind;

    use super::ReliefValve;
    use crate::asked::{along, case, close, special};

    /// p = y + δ and y √p = q at rest; Hurwitz's determinant of the cubic vanishes there.
    #[test]
    fn flutter_begins_where_hurwitz_says() {
        let (system, case) = case(&ReliefValve::default());
        let case = along(&case, ReliefValve::q, 9.0, 8.0);
        let record = system.equilibria_along(&case, &mut |_| ControlFlow::Continue(()));
        let (q, frequency) = special(&record.unwrap(), Kind::Hopf);
        close(q, 8.491117635183326, 1e-9, "inflow");
        close(frequency, 3.0907088479743408, 1e-9, "frequency");
        let ReliefValve {
            kappa, delta, beta, ..
        } = ReliefValve::default();
        let y = 2.41031323768665_f64;
        close(y * (y + delta).sqrt(), q, 1e-9, "inflow");
        let root = (y + delta).sqrt();
        let (a, b) = (beta * y / (2.0 * root), beta * root);
        let hurwitz = (kappa + a) * (1.0 + kappa * a) - (a + b);
        close(hurwitz / b, 0.0, 1e-9, "Hurwitz's determinant");
    }

    #[test]
    fn the_cycle_grazes_the_seat_and_is_hit_beyond() {
        let (system, mut case) = case(&ReliefValve {
            q: 8.3,
            ..ReliefValve::default()
        });
        case.start = Some(vec![2.0, 0.0, 12.0]);
        let case = along(&case, ReliefValve::q, 8.3, 7.3);
        let branch = system.branch(&case, &mut |_| ControlFlow::Continue(()));
        let branch = branch.unwrap();
        let grazing = branch.special.iter().find(|one| one.kind == Kind::Grazing);
        assert!(grazing.is_some(), "{:?}", branch.special);
        let hit = branch
            .points
            .iter()
            .any(|point| point.word.as_deref() == Some("impact(R)"));
        assert!(hit, "{}", branch.ended.reason);
        assert!(branch.points.iter().all(|point| point.min[0] >= -1e-9));
    }
}

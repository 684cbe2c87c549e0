//! A rotor that whirls because its material rubs inside.
//!
//! A. L. Kimball, Internal friction theory of shaft whirling, General Electric Review 27 (1924) 244; D. M. Smith, The
//! motion of a rotor carried by a flexible shaft in flexible bearings, Proc. R. Soc. Lond. A 142 (1933) 92, with the
//! threshold ω_n (1 + c_e/c_i). The stiffening of the shaft, which bounds the whirl, is added here, and all values.

use stickslip::model;

model! {
    /// A rotor with internal and external damping on a stiffening shaft: Kimball 1924, Smith 1933.
    pub struct Rotor {
        state x: m = 0.5;
        state y: m = 0.0;
        state vx: m/s = 0.0;
        state vy: m/s = 1.0;
        param mass: kg = 1.0 where mass > 0.0;
        param k: N/m = 1.0 where k > 0.0;
        /// Stiffness that grows with the square of the deflection.
        param stiffening: N/m^3 = 1.0 where stiffening > 0.0;
        /// External damping.
        param outside: N*s/m = 0.1 where outside >= 0.0;
        /// Damping inside of the shaft, which turns with it.
        param inside: N*s/m = 0.2 where inside >= 0.0;
        /// Speed of rotation.
        param Omega: rad/s = 2.0;
        let stiffness = k + stiffening * (powi(x, 2) + powi(y, 2));
        der(x) = vx;
        der(y) = vy;
        der(vx) = (-stiffness * x - outside * vx - inside * (vx + Omega * y)) / mass;
        der(vy) = (-stiffness * y - outside * vy - inside * (vy - Omega * x)) / mass;
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use stickslip::continuation::Kind;

    use super::Rotor;
    use crate::asked::{case, close, special};

    /// Smith's threshold ω_n (1 + c_e/c_i), at which the whirl has the frequency ω_n.
    #[test]
    fn the_threshold_is_smiths() {
        for (outside, inside) in [(0.1, 0.2), (0.02, 0.05), (0.3, 0.5)] {
            let model = Rotor {
                outside,
                inside,
                k: 4.0,
                ..Rotor::default()
            };
            let (system, case) = case(&model);
            let case = case.following(Rotor::Omega, 1.0..5.0);
            let record = system.equilibria_along(&case);
            let (threshold, frequency) = special(&record.unwrap(), Kind::Hopf);
            close(threshold, 2.0 * (1.0 + outside / inside), 1e-9, "threshold");
            close(frequency, 2.0, 1e-9, "frequency");
        }
    }

    /// Beyond it the whirl is circular: both dampings balance at the frequency ω = Ω c_i/(c_e + c_i), at which the shaft
    /// has just the stiffness m ω².
    #[test]
    fn the_whirl_is_a_closed_form() {
        for speed in [1.6, 2.0, 5.0] {
            let model = Rotor {
                Omega: speed,
                ..Rotor::default()
            };
            let (system, case) = case(&model);
            let orbit = system.orbit(&case).unwrap();
            let frequency = speed * model.inside / (model.outside + model.inside);
            let radius = ((frequency * frequency - model.k) / model.stiffening).sqrt();
            close(orbit.period, TAU / frequency, 1e-8 * orbit.period, "period");
            for state in [0, 1] {
                close(orbit.max[state], radius, 1e-8 * radius, "radius");
            }
        }
    }
}

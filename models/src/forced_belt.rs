//! A mass on a belt under a harmonic force.

use crate::friction::Weakening;
use stickslip::model;

model! {
    /// A mass on a belt, held by a spring and shaken by a harmonic force: after Popp and Stelter 1990.
    pub struct ForcedBelt {
        /// Displacement of the mass.
        state x: m = 0.0;
        /// Velocity of the mass.
        state v: m/s = 0.0;

        /// Mass.
        param m: kg = 1.0 where m > 0.0;
        /// Spring stiffness.
        param k: N/m = 1.0 where k > 0.0;
        /// Velocity of the belt.
        param v_dr: m/s = 0.5;
        /// Amplitude of the force.
        param load: N = 0.5;
        /// Angular frequency of the force.
        param omega: rad/s = 0.6 where omega > 0.0;
        /// Largest static friction force.
        param F_s: N = 1.0 where F_s >= 0.0;
        /// Rate at which friction weakens with speed.
        param delta: s/m = 1.0 where delta >= 0.0;

        /// Phase of the force.
        drive phi at omega;
        friction F: N = Weakening { limit: F_s, decay: delta } opposing v - v_dr;

        der(x) = v;
        der(v) = (F - k * x + load * cos(phi)) / m;
    }
}

// The same model, declared.

use stickslip::model;
use stickslip_models::friction::Weakening;

model! {
    /// One mass on a moving belt, held by a spring.
    pub struct Belt {
        /// Displacement of the mass.
        state x: m = 1.0;
        /// Velocity of the mass.
        state v: m/s = 0.0;
        /// Mass.
        param m: kg = 1.0 where m > 0.0;
        /// Spring stiffness.
        param k: N/m = 1.0 where k > 0.0;
        /// Velocity of the belt.
        param v_dr: m/s = 0.2;
        /// Largest static friction force.
        param F_s: N = 1.0 where F_s >= 0.0;
        /// Rate at which friction weakens with speed.
        param delta: s/m = 3.0 where delta >= 0.0;
        friction F: N = Weakening { limit: F_s, decay: delta } opposing v - v_dr;
        der(x) = v;
        der(v) = (F - k * x) / m;
    }
}

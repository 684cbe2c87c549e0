//! The Van der Pol oscillator: a limit cycle without friction.

use stickslip::model;

model! {
    /// The Van der Pol equation: thesis (3.1).
    pub struct VanDerPol {
        /// Displacement.
        state x = 2.0;
        /// Velocity.
        state v = 0.0;
        /// Strength of the nonlinear damping.
        param nu = 1.0 where nu >= 0.0;
        der(x) = v;
        der(v) = -nu * (powi(x, 2) - 1) * v - x;
    }
}

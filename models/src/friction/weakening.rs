//! Friction that weakens with the sliding speed.

use stickslip::friction_law;

friction_law! {
    /// Weakens with sliding speed: thesis (3.5), Galvanetto et al.
    pub struct Weakening {
        /// Largest static force.
        param limit: N where limit >= 0.0;
        /// Rate at which the force decreases with speed.
        param decay: s/m where decay >= 0.0;

        stick = limit;
        slip(s) = limit / (1.0 + decay * s);
    }
}

//! Two coupled masses on one belt.

use stickslip::model;

use crate::friction::Weakening;

model! {
    /// Two coupled masses on one belt, nondimensional: thesis section 3.3, (3.10).
    pub struct BeltPair {
        /// Displacement of the first mass.
        state x1 = -0.5976;
        /// Velocity of the first mass.
        state v1 = 0.0;
        /// Displacement of the second mass.
        state x2 = -0.4604;
        /// Velocity of the second mass.
        state v2 = -0.1607;
        /// Stiffness of the coupling spring.
        param alpha = 1.2 where alpha >= 0.0;
        /// Friction limit of the second mass over that of the first.
        param beta = 1.3 where beta > 0.0;
        /// Rate at which friction weakens with speed.
        param gamma = 3.0 where gamma >= 0.0;
        /// Velocity of the belt.
        param v_dr = 0.14;
        /// Force of the belt on the first mass.
        friction f1 = Weakening { limit: 1.0, decay: gamma } opposing v1 - v_dr;
        /// Force of the belt on the second mass.
        friction f2 = Weakening { limit: beta, decay: gamma } opposing v2 - v_dr;
        /// Force of the coupling spring.
        let coupling = alpha * (x1 - x2);
        der(x1) = v1;
        der(v1) = -x1 - coupling + f1;
        der(x2) = v2;
        der(v2) = -x2 + coupling + f2;
    }
}

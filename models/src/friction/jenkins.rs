//! A spring in series with a slider.

use stickslip::friction_law;

friction_law! {
    /// Jenkins element: force F = z of a spring that stretches with the contact, ż = k w, and slips at |z| = F_c.
    ///
    /// At its stops the slider moves and the spring does not: ż = 0 until w turns. Over whole swings of amplitude A the
    /// force runs round a parallelogram of area 4 F_c (A − F_c/k); below A = F_c/k nothing is lost. Several elements at
    /// one contact, each with a state of its own, are a parallel Iwan model, which obeys Masing's rule.
    /// Source: Jenkin, Engineering 114 (1922) 603; Iwan, J. Appl. Mech. 33 (1966) 893.
    pub struct Jenkins {
        /// Force in the spring.
        state z: N;
        /// k: stiffness of the spring.
        param stiffness: N/m where stiffness > 0.0;
        /// F_c: force at which the slider slips.
        param level: N where level > 0.0;

        der(z) = stiffness * w;
        stop z at level;
        force(w) = z;
    }
}

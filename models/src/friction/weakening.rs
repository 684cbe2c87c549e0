//! Friction that weakens with the sliding speed.

use stickslip::friction_law;

friction_law! {
    /// Weakens with sliding speed: thesis (3.5), Galvanetto et al.
    ///
    /// With F_s = `limit`, δ = `decay`:
    ///
    /// |F| ≤ F_s at rest, F_s/(1 + δ s) at the sliding speed s
    ///
    /// Source: U. Galvanetto, S. R. Bishop, L. Briseghella, Int. J. Bifurcation and Chaos 5, 1995.
    pub struct Weakening {
        /// Largest static force.
        param limit: N where limit >= 0.0;
        /// Rate at which the force decreases with speed.
        param decay: s/m where decay >= 0.0;

        stick = limit;
        slip(s) = limit / (1.0 + decay * s);
    }
}

//! Friction torque at a drill bit.

use stickslip::friction_law;

friction_law! {
    /// Leine's drill curve: torque at the bit that weakens, with viscous damping by the mud.
    ///
    /// With T_s = `limit`, δ = `decay`, b = `viscous`:
    ///
    /// |T| ≤ T_s at rest, T_s/(1 + δ s) + b s at the sliding speed s
    ///
    /// Of a torque, N stands for N*m and m for rad: T_s is in N*m, δ in s/rad, b in N*m*s/rad.
    ///
    /// Source: R. I. Leine, D. H. van Campen, W. J. G. Keultjes, J. Vibration and Acoustics 124, 2002.
    pub struct DrillCurve {
        /// Largest static torque.
        param limit: N where limit >= 0.0;
        /// Rate at which the torque decreases with speed.
        param decay: s/m where decay >= 0.0;
        /// Torque that grows with speed.
        param viscous: N*s/m where viscous >= 0.0;

        stick = limit;
        slip(s) = limit / (1.0 + decay * s) + viscous * s;
    }
}

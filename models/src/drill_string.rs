//! A drill string in torsion.

use stickslip::model;

use crate::friction::CoulombStatic;

model! {
    /// Drill string in torsion, nondimensional: thesis section 4.2, (4.6).
    pub struct DrillString {
        /// Twist, measured from the sliding equilibrium.
        state psi = 6.0;
        /// Twist rate (the bit's speed is eta - omega).
        state omega = 0.0;
        /// Speed of the rotary table.
        param eta = 4.0 where eta > 0.0;
        /// Static minus kinetic torque at the bit.
        param theta = 4.2 where theta >= 0.0;
        /// Kinetic torque at the bit.
        param kinetic = 4.2 where kinetic >= 0.0;
        /// Damping ratio.
        param zeta = 0.05 where zeta >= 0.0;
        /// Friction torque at the bit.
        friction T_b = CoulombStatic { static_level: kinetic + theta, kinetic_level: kinetic } opposing eta - omega;
        /// Friction torque on the twist, measured from the kinetic one: thesis (4.7).
        let T_c = -(T_b + kinetic);
        der(psi) = omega;
        der(omega) = -2 * zeta * omega - psi + T_c;
    }
}

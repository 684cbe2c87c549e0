//! Torque on a drill bit under its weight.

use stickslip::friction_law;

friction_law! {
    /// Navarro-López's torque on bit: dry friction of the rock under the weight on the bit.
    ///
    /// With W R_b = `reach`, μ_s = `static_coefficient`, μ_c = `kinetic_coefficient` ≤ μ_s, γ_b = `decay`, v_f = `speed`:
    ///
    /// |T| ≤ W R_b μ_s at rest, W R_b (μ_c + (μ_s − μ_c) exp(−γ_b s/v_f)) at the sliding speed s
    ///
    /// Of a torque, N stands for N*m and m for rad: `reach` is the weight on the bit times the bit's radius, in N*m,
    /// and v_f is in rad/s.
    ///
    /// Source: E. M. Navarro-López, D. Cortés, J. Sound and Vibration 307, 2007.
    pub struct BitTorque {
        /// Weight on the bit times the radius of the bit.
        param reach: N where reach >= 0.0;
        /// Coefficient of static friction, not below the kinetic one.
        param static_coefficient: 1 where static_coefficient >= 0.0;
        /// Coefficient of friction to which it falls.
        param kinetic_coefficient: 1 where kinetic_coefficient >= 0.0;
        /// Rate of the fall.
        param decay: 1 where decay >= 0.0;
        /// Speed against which the fall is measured.
        param speed: m/s where speed > 0.0;

        stick = reach * static_coefficient;
        slip(s) = reach
            * (kinetic_coefficient
                + (static_coefficient - kinetic_coefficient) * exp(-decay * s / speed));
    }
}

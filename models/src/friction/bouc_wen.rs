//! Hysteresis of many shapes.

use stickslip::friction_law;

friction_law! {
    /// Bouc-Wen with exponent 1: F = α k y + (1 − α) k z with ż = A w − β |w| z − γ w |z|.
    ///
    /// The displacement y of the contact is an internal state too: ẏ = w. The hysteretic part saturates at
    /// z = A/(β + γ). Loading from z = 0 gives z = A/(β + γ) (1 − e^{−(β + γ) y}).
    /// Source: Bouc, 4th Conference on Nonlinear Oscillation, Prague 1967; Wen, J. Eng. Mech. Div. ASCE 102 (1976) 249.
    pub struct BoucWen {
        /// Displacement of the contact.
        state y: m;
        /// Hysteretic displacement.
        state z: m;
        /// k: initial stiffness.
        param stiffness: N/m where stiffness > 0.0;
        /// α: part of the stiffness that is left when the hysteretic part has saturated.
        param left: 1 where 0.0 <= left <= 1.0;
        /// A: initial slope of z.
        param slope: 1 where slope > 0.0;
        /// β.
        param beta: 1/m where beta > 0.0;
        /// γ, between −β and β for loops that dissipate.
        param gamma: 1/m;

        der(y) = w;
        der(z) = slope * w - beta * abs(w) * z - gamma * w * abs(z);
        force(w) = left * stiffness * y + (1 - left) * stiffness * z;
    }
}

friction_law! {
    /// Bouc-Wen with any exponent n > 1: F = α k y + (1 − α) k z with ż = A w − β |w| |z|ⁿ⁻¹ z − γ w |z|ⁿ.
    ///
    /// As [`BoucWen`], which is the case n = 1; it saturates at z = (A/(β + γ))^{1/n}. Here z is measured in units of
    /// a displacement of yielding, so that |z|ⁿ has a meaning: `scale` is that displacement.
    /// Source: Wen, J. Eng. Mech. Div. ASCE 102 (1976) 249.
    pub struct BoucWenPower {
        /// Displacement of the contact.
        state y: m;
        /// Hysteretic displacement, in units of the displacement of yielding.
        state z: 1;
        /// Displacement of yielding.
        param scale: m where scale > 0.0;
        /// k: initial stiffness.
        param stiffness: N/m where stiffness > 0.0;
        /// α: part of the stiffness that is left when the hysteretic part has saturated.
        param left: 1 where 0.0 <= left <= 1.0;
        /// A: initial slope of z.
        param slope: 1 where slope > 0.0;
        /// β.
        param beta: 1 where beta > 0.0;
        /// γ, between −β and β for loops that dissipate.
        param gamma: 1;
        /// n.
        param exponent: 1 where exponent > 1.0;

        let size = powf(abs(z), exponent);
        der(y) = w;
        der(z) = (slope * w - size * (beta * abs(w) * sign(z) + gamma * w)) / scale;
        force(w) = left * stiffness * y + (1 - left) * stiffness * scale * z;
    }
}

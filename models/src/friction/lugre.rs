//! Bristles whose force falls with the speed of sliding.

use stickslip::friction_law;

friction_law! {
    /// LuGre: F = σ₀ z + σ₁ ż + σ₂ w with ż = w − σ₀ |w| z / g(w) and g(w) = F_c + (F_s − F_c) e^{−(w/v_s)²}.
    ///
    /// Sliding steadily, the force is g(w) sgn w + σ₂ w, a Stribeck curve. Break-away needs the less force the faster
    /// that force rises; under a force below F_c that vibrates, the body drifts, which real contacts do not.
    /// Source: Canudas de Wit, Olsson, Åström and Lischinsky, IEEE Trans. Automatic Control 40 (1995) 419.
    pub struct LuGre {
        /// Deflection of the bristles.
        state z: m;
        /// σ₀: stiffness of the bristles.
        param stiffness: N/m where stiffness > 0.0;
        /// σ₁: damping of the bristles.
        param damping: N*s/m where damping >= 0.0;
        /// σ₂: viscous friction.
        param viscous: N*s/m where viscous >= 0.0;
        /// F_c: force of fast sliding.
        param kinetic: N where kinetic > 0.0;
        /// F_s: force of slow sliding.
        param peak: N where peak > 0.0;
        /// v_s: speed within which the force falls.
        param stribeck: m/s where stribeck > 0.0;

        let steady = kinetic + (peak - kinetic) * exp(-powi(w / stribeck, 2));
        let rate = w - stiffness * abs(w) * z / steady;
        der(z) = rate;
        force(w) = stiffness * z + damping * rate + viscous * w;
    }
}

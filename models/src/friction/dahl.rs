//! A solid that yields before it slides.

use stickslip::friction_law;

friction_law! {
    /// Dahl: force F = σ₀ z of bristles that bend by z, with ż = w − σ₀ |w| z / F_c.
    ///
    /// Force and displacement are related without regard to speed: a hysteresis loop whose branches are exponentials,
    /// F = ±F_c + (F₀ ∓ F_c) e^{∓σ₀ (x − x₀)/F_c}. The force never exceeds F_c, so that nothing breaks away suddenly.
    /// Source: Dahl, A solid friction model, Aerospace Corporation TOR-0158(3107-18)-1, 1968, with exponent 1.
    pub struct Dahl {
        /// Deflection of the bristles.
        state z: m;
        /// σ₀: stiffness of the bristles.
        param stiffness: N/m where stiffness > 0.0;
        /// F_c: force of steady sliding.
        param level: N where level > 0.0;

        der(z) = w - stiffness * abs(w) * z / level;
        force(w) = stiffness * z;
    }
}

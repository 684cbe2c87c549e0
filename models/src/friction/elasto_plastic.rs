//! Bristles that bend elastically before they yield.

use stickslip::friction_law;

friction_law! {
    /// Elasto-plastic: LuGre with ż = w (1 − α σ₀ z sgn w / g(w)), where α is 0 while the bristles only bend.
    ///
    /// With u = z sgn w, α is 0 up to u = z_ba, rises as (1 − cos πt)/2 with t = (u − z_ba)/(z_max − z_ba), and is 1
    /// from z_max = g(w)/σ₀ on. Below break-away all displacement is given back: a vibrating force makes no drift.
    /// Source: Dupont, Hayward, Armstrong and Altpeter, IEEE Trans. Automatic Control 47 (2002) 787.
    pub struct ElastoPlastic {
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
        /// z_ba: deflection up to which it is elastic; less than F_c/σ₀ and F_s/σ₀.
        param elastic: m where elastic > 0.0;

        let steady = kinetic + (peak - kinetic) * exp(-powi(w / stribeck, 2));
        let t = (z * sign(w) - elastic) / (steady / stiffness - elastic);
        let clamped = (1 + abs(t) - abs(t - 1)) / 2;
        let plastic = (1 - cos(std::f64::consts::PI * clamped)) / 2;
        let rate = w - plastic * stiffness * abs(w) * z / steady;
        der(z) = rate;
        force(w) = stiffness * z + damping * rate + viscous * w;
    }
}

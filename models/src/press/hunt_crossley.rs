//! The damped contact of Hunt and Crossley.

use stickslip::press_law;

press_law! {
    /// A spring whose damping grows with its force, so that this begins and ends with the gap.
    ///
    /// With k = `stiffness`, n = `exponent`, λ = `damping` and the depth d:
    ///
    /// F = k d^n (1 + λ ḋ)
    ///
    /// A slow impact at the speed v loses the share (2/3) λ v of its speed. Source: K. H. Hunt and F. R. E. Crossley,
    /// Coefficient of restitution interpreted as damping in vibroimpact, J. Appl. Mech. 42 (1975) 440.
    pub struct HuntCrossley {
        /// Force at the depth `depth`.
        param load: N where load > 0.0;
        /// Depth at which a slow contact bears `load`.
        param depth: m where depth > 0.0;
        /// Exponent of the depth.
        param exponent: 1 where exponent >= 1.0;
        /// Share by which a unit of speed raises the force.
        param damping: s/m where damping >= 0.0;

        force(d, v) = load * powf(d / depth, exponent) * (1.0 + damping * v);
    }
}

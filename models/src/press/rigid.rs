//! A contact that does not give way.

use stickslip::press_law;

press_law! {
    /// Impacts after Newton: what parts at the speed v⁺ has met at the speed v⁻.
    ///
    /// With e = `restitution`:
    ///
    /// v⁺ = e v⁻
    pub struct Rigid {
        /// Coefficient of restitution: 1 loses nothing, 0 stays closed.
        param restitution: 1 where 0.0 <= restitution <= 1.0;

        rebound(v) = restitution * v;
    }
}

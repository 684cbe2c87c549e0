//! A spring beside a damper.

use stickslip::press_law;

press_law! {
    /// A linear spring beside a linear damper, after Kelvin and Voigt.
    ///
    /// With k = `stiffness`, c = `damping` and the depth d:
    ///
    /// F = k d + c ḋ
    ///
    /// The damper makes the force begin with a jump where the gap closes, and end before the gap opens.
    pub struct Compliant {
        /// Stiffness of the spring.
        param stiffness: N/m where stiffness > 0.0;
        /// Coefficient of the damper.
        param damping: N*s/m where damping >= 0.0;

        force(d, v) = stiffness * d + damping * v;
    }
}

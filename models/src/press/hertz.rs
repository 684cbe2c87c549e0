//! The elastic contact of Hertz.

use stickslip::press_law;

press_law! {
    /// The contact of two round elastic bodies.
    ///
    /// With P = `load`, p = `depth` and the depth d:
    ///
    /// F = P (d/p)^(3/2)
    ///
    /// Of spheres, P = (4/3) E* √R p^(3/2). Source: H. Hertz, Über die Berührung fester elastischer Körper, J. reine angew.
    /// Math. 92 (1882) 156.
    pub struct Hertz {
        /// Force at the depth `depth`.
        param load: N where load > 0.0;
        /// Depth at which the contact bears `load`.
        param depth: m where depth > 0.0;

        force(d, v) = load * powf(d / depth, 1.5);
    }
}

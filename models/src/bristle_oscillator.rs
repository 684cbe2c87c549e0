//! A mass that is pulled by a spring over bristles.

use crate::friction::LuGre;
use stickslip::model;

model! {
    /// A mass pulled by a spring with the LuGre law: stick-slip after Canudas de Wit et al. 1995, Fig. 5.
    pub struct BristleOscillator {
        /// Stretch of the spring.
        state stretch: m = 0.0;
        /// Velocity of the mass.
        state v: m/s = 0.0;
        /// Deflection of the bristles.
        state z: m = 0.0;

        /// Mass.
        param m: kg = 1.0 where m > 0.0;
        /// Stiffness of the spring.
        param k: N/m = 2.0 where k > 0.0;
        /// Velocity at which the spring is pulled.
        param pull: m/s = 0.1;
        /// Stiffness of the bristles.
        param sigma_0: N/m = 1e5 where sigma_0 > 0.0;
        /// Damping of the bristles: the square root of 1e5.
        param sigma_1: N*s/m = 316.227766016838 where sigma_1 >= 0.0;
        /// Viscous friction.
        param sigma_2: N*s/m = 0.4 where sigma_2 >= 0.0;
        /// Force of fast sliding.
        param F_c: N = 1.0 where F_c > 0.0;
        /// Force of slow sliding.
        param F_s: N = 1.5 where F_s > 0.0;
        /// Speed within which friction falls.
        param v_s: m/s = 0.001 where v_s > 0.0;

        friction F: N = LuGre {
            stiffness: sigma_0, damping: sigma_1, viscous: sigma_2, kinetic: F_c, peak: F_s, stribeck: v_s,
        } opposing v with z;

        der(stretch) = pull - v;
        der(v) = (k * stretch + F) / m;
    }
}

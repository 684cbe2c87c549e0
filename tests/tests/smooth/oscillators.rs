//! Driven oscillators whose responses are closed forms.

use stickslip::model;
use stickslip_models::friction::Coulomb;

model! {
    /// A damped oscillator under a harmonic force.
    pub(crate) struct Forced {
        state x: m = 0.0;
        state v: m/s = 0.0;
        param zeta = 0.1 where zeta > 0.0;
        param omega: rad/s = 1.3;
        param load: N/kg = 2.0;
        param natural: rad/s = 1.0 where natural > 0.0;
        drive phi at omega;
        der(x) = v;
        der(v) = load * cos(phi) - 2 * zeta * natural * v - natural * natural * x;
    }
}

model! {
    /// Den Hartog's oscillator: dry and viscous friction, here dry alone.
    pub(crate) struct DenHartog {
        state x = 1.0;
        state v = 0.0;
        param beta = 0.6 where beta > 0.0;
        param level = 0.2 where level >= 0.0;
        drive phi at beta;
        friction F = Coulomb { level } opposing v;
        der(x) = v;
        der(v) = cos(phi) - x + F;
    }
}

use stickslip::model;
use stickslip_models::friction::Tustin;

model! {
    /// A brake pad on its bracket, pressed against a turning disc.
    pub struct BrakePad {
        state x: m = 0.0;
        state v: m/s = 0.0;
        param mass: kg = 1.0 where mass > 0.0;
        param bracket: N/m = 100.0 where bracket > 0.0;
        param damping: N*s/m = 4.0 where damping >= 0.0;
        param pressed: N = 20.0 where pressed >= 0.0;
        param disc: m/s = 0.2 where disc > 0.0;
        friction F: N = Tustin { static_level: 0.5 * pressed, kinetic_level: 0.3 * pressed, speed: 0.2, viscous: 0.0 } opposing v - disc;
        der(x) = v;
        der(v) = (F - bracket * x - damping * v) / mass;
    }
}

stickslip::app!(BrakePad);

//! The state that carries an internal state has another unit.

use stickslip::model;
use stickslip_models::friction::Dahl;

model! {
    pub struct Sledge {
        state v: m/s = 1.0;
        state z: m/s = 0.0;
        param mass: kg = 1.0 where mass > 0.0;
        param stiffness: N/m = 1.0 where stiffness > 0.0;
        param level: N = 1.0 where level > 0.0;
        friction F: N = Dahl { stiffness, level } opposing v with z;
        der(v) = F / mass;
    }
}

fn main() {}

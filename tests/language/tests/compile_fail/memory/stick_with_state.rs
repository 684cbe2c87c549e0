//! A law with internal state and a force at rest.

use stickslip::friction_law;

friction_law! {
    pub struct Both {
        state z: m;
        param stiffness: N/m where stiffness > 0.0;
        param level: N where level > 0.0;
        stick = level;
        der(z) = w - stiffness * abs(w) * z / level;
        force(w) = stiffness * z;
    }
}

fn main() {}

//! A law with internal state that says no force, and moves only one of its states.

use stickslip::friction_law;

friction_law! {
    pub struct Mute {
        state y: m;
        state z: m;
        param stiffness: N/m where stiffness > 0.0;
        param level: N where level > 0.0;
        der(z) = -stiffness * z / level * z;
    }
}

fn main() {}

//! A force that jumps with the sign of the speed is dry friction.

use stickslip::friction_law;

friction_law! {
    pub struct Jumping {
        state z: m;
        param stiffness: N/m where stiffness > 0.0;
        param level: N where level > 0.0;
        der(z) = w - stiffness * abs(w) * z / level;
        force(w) = stiffness * z + level * sign(w);
    }
}

fn main() {}

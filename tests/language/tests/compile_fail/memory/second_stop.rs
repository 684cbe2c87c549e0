//! One stop stands on both sides.

use stickslip::friction_law;

friction_law! {
    pub struct Spring {
        state z: N;
        param stiffness: N/m where stiffness > 0.0;
        param level: N where level > 0.0;
        der(z) = stiffness * w;
        stop z at level;
        stop z at 2 * level;
        force(w) = z;
    }
}

fn main() {}

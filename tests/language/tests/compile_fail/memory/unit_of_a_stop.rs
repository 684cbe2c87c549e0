//! A stop is in the unit of what it stops.

use stickslip::friction_law;

friction_law! {
    pub struct Spring {
        state z: N;
        param stiffness: N/m where stiffness > 0.0;
        param level: N where level > 0.0;
        der(z) = stiffness * w;
        stop z at level / stiffness;
        force(w) = z;
    }
}

fn main() {}

//! A kink that is written with another function than `abs` and `sign`.

use stickslip::friction_law;

friction_law! {
    pub struct Clipped {
        state z: m;
        param stiffness: N/m where stiffness > 0.0;
        param level: N where level > 0.0;
        der(z) = w - stiffness * abs(w) * z / level;
        force(w) = min(stiffness * z, level);
    }
}

fn main() {}

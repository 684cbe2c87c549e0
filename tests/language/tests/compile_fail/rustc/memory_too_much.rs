//! More states after `with` than the law has internal states.

use stickslip::{friction_law, model};

friction_law! {
    pub struct Dahl {
        state z: m;
        param stiffness: N/m where stiffness > 0.0;
        param level: N where level > 0.0;
        der(z) = w - stiffness * abs(w) * z / level;
        force(w) = stiffness * z;
    }
}

model! {
    pub struct Sledge {
        state v = 1.0;
        state z = 0.0;
        state y = 0.0;
        friction F = Dahl { stiffness: 1.0, level: 1.0 } opposing v with z, y;
        der(v) = F;
    }
}

fn main() {}

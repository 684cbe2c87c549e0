//! A state to carry the memory of a law that has none.

use stickslip::{friction_law, model};

friction_law! {
    pub struct Coulomb {
        param level: N where level >= 0.0;
        stick = level;
        slip(s) = level;
    }
}

model! {
    pub struct Sledge {
        state v = 1.0;
        state z = 0.0;
        friction F = Coulomb { level: 1.0 } opposing v with z;
        der(v) = F;
    }
}

fn main() {}

//! One state for the memory of two contacts, and an equation for it besides.

use stickslip::model;
use stickslip_models::friction::Dahl;

model! {
    pub struct Sledges {
        state v = 1.0;
        state u = 1.0;
        state z = 0.0;
        friction F = Dahl { stiffness: 1.0, level: 1.0 } opposing v with z;
        friction G = Dahl { stiffness: 1.0, level: 1.0 } opposing u with z;
        der(v) = F;
        der(u) = G;
        der(z) = u;
    }
}

fn main() {}

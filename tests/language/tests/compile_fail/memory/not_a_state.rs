//! What stands after `with` is misspelt.

use stickslip::model;
use stickslip_models::friction::Dahl;

model! {
    pub struct Sledge {
        state v = 1.0;
        state bristles = 0.0;
        friction F = Dahl { stiffness: 1.0, level: 1.0 } opposing v with bristels;
        der(v) = F;
    }
}

fn main() {}

use stickslip::model;
use stickslip_models::friction::Weakening;

model! {
    pub struct Belt {
        state v = 0.0;
        friction F = Weakning { limit: 1.0, decay: 3.0 } opposing v;
        let push = 2.0 * F;
        der(v) = push;
    }
}

fn main() {}

use stickslip::model;
use stickslip_models::friction::Weakening;

model! {
    pub struct Belt {
        state v = 0.0;
        friction F = Weakening { limit: 1.0 } opposing v;
        der(v) = F;
    }
}

fn main() {}

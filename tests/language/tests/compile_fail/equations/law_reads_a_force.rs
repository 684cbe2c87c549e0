use stickslip::model;
use stickslip_models::friction::Weakening;

model! {
    pub struct Belt {
        state v = 0.0;
        friction F = Weakening { limit: 1.0, decay: 3.0 } opposing v - 0.2;
        friction G = Weakening { limit: 1.0 + F, decay: 3.0 } opposing v;
        der(v) = F + G;
    }
}

fn main() {}

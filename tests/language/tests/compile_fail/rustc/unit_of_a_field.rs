use stickslip::model;
use stickslip_models::friction::Weakening;

model! {
    pub struct Belt {
        state v: m/s = 0.0;
        param m: kg = 1.0;
        friction F: N = Weakening { limit: m, decay: 3.0 } opposing v;
        der(v) = F / m;
    }
}

fn main() {}

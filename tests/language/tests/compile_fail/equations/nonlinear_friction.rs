use stickslip::model;
use stickslip_models::friction::Weakening;

model! {
    pub struct Belt {
        state x = 1.0;
        state v = 0.0;
        friction F = Weakening { limit: 1.0, decay: 3.0 } opposing v - 0.2;
        let pull = F - x;
        der(x) = v;
        der(v) = pull * pull;
    }
}

fn main() {}

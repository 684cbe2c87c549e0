use stickslip::model;

model! {
    pub struct Oscillator {
        state x = 1.0;
        state v = 0.0;
        friction F = stickslip_models::friction::Coulomb { level: 1.0 } opposing v;
        der(x) = v;
        der(v) = -x;
    }
}

fn main() {}

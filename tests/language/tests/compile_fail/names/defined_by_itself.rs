use stickslip::model;

model! {
    pub struct Oscillator {
        state x = 1.0;
        state v = 0.0;
        let pull = x + pull;
        der(x) = v;
        der(v) = -pull;
    }
}

fn main() {}

use stickslip::model;

model! {
    pub struct Oscillator {
        state x = 1.0;
        state v = 0.0;
        param mass = 1.0;
        der(x) = v;
        der(v) = -max(x - 1.0, 0.0) / mass - v;
    }
}

fn main() {}

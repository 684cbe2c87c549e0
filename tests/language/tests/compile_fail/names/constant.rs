use stickslip::model;

model! {
    pub struct Oscillator {
        state x = 1.0;
        state v = 0.0;
        der(x) = v;
        der(v) = -x * PI;
    }
}

fn main() {}

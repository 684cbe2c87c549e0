use stickslip::model;

model! {
    pub struct Oscillator {
        state x = 1.0;
        state v = 0.0;
        param k = 2.0;
        der(x) = v;
        der(v) = -k x;
    }
}

fn main() {}

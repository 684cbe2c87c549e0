use stickslip::model;

model! {
    pub struct Oscillator {
        state m = 1.0;
        state v = 0.0;
        param m = 1.0;
        der(m) = v;
        der(v) = -m;
    }
}

fn main() {}

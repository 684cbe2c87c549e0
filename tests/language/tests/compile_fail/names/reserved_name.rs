use stickslip::model;

model! {
    pub struct Oscillator {
        state x = 1.0;
        param default = 1.0;
        der(x) = -default * x;
    }
}

fn main() {}

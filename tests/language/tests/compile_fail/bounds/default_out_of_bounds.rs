use stickslip::model;

model! {
    pub struct Oscillator {
        state x = 1.0;
        param zeta = 1.5 where 0 <= zeta < 1;
        der(x) = -zeta * x;
    }
}

fn main() {}

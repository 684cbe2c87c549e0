use stickslip::model;

model! {
    pub struct Oscillator {
        state x = 1.0;
        param zeta = 0.5 where 1.0 < zeta < 0.0;
        der(x) = -zeta * x;
    }
}

fn main() {}

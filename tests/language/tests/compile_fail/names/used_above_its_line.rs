use stickslip::model;

model! {
    pub struct Oscillator {
        state x = 1.0;
        let twice = 2.0 * once;
        let once = -x;
        der(x) = twice;
    }
}

fn main() {}

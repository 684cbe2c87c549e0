use stickslip::model;

model! {
    pub struct Oscillator {
        state x = 1.0;
        state v = 0.0;
        param mass = one;
        der(x) = v;
        der(v) = -x / mass;
    }
}

fn heavy() -> Oscillator {
    Oscillator { mass: 2.0 }
}

fn main() {}

use stickslip::model;

model! {
    pub struct Oscillator {
        state x: m = 1.0;
        state v: m/s = 0.0;
        param k: 1/s^2 = 1.0;
        param shape: s = 1.5;
        der(x) = v;
        der(v) = -k * x * powf(2.0, shape);
    }
}

fn main() {}

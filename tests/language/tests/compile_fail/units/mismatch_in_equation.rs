use stickslip::model;

model! {
    pub struct Oscillator {
        state x: m = 1.0;
        state v: m/s = 0.0;
        param mass: kg = 1.0;
        param k: N/m = 1.0;
        param c: N*s/m = 1.0;
        der(x) = v;
        der(v) = -k * x - c * v * mass / mass;
    }
}

fn main() {}

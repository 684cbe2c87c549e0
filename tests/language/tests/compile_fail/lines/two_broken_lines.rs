use stickslip::model;

model! {
    pub struct Oscillator {
        state x = 1.0;
        state v = ;
        param mass 1.0;
        param k: N m = 1.0;
        der(x) = v;
        der(v) = -k * x / mass;
    }
}

fn main() {}

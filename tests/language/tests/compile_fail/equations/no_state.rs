use stickslip::model;

model! {
    pub struct Oscillator {
        param mass = 1.0;
        let weight = 9.81 * mass;
    }
}

fn main() {}

use stickslip::model;

model! {
    pub struct Beam {
        structure beam = "beam.structure" keeping 4;
        param push: N = 1.0;
        param omega: rad/s = 1.0;
        load beam.end = push * omega;
    }
}

fn main() {}

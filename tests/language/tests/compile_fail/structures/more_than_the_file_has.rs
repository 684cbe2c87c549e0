use stickslip::model;

model! {
    pub struct Beam {
        structure beam = "beam.structure" keeping 12;
        param push: N = 1.0;
        load beam.end = push;
    }
}

fn main() {}

use stickslip::model;

model! {
    pub struct Beam {
        structure beam = "/nowhere/beam.structure" keeping 4;
        param push: N = 1.0;
        load beam.end = push;
    }
}

fn main() {}

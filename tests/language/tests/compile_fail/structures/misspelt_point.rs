use stickslip::model;

model! {
    pub struct Beam {
        structure beam = "beam.structure" keeping 4;
        param push: N = 1.0;
        load beam.ent = push;
    }
}

fn main() {}

use stickslip::friction_law;

friction_law! {
    pub struct Rubber {
        param limit: N = 1.0;
        stick = limit;
        slip(s) = limit;
    }
}

fn main() {}

use stickslip::friction_law;

friction_law! {
    pub struct Rubber {
        param limit: N;
        stick = limit;
        slip(s) = limit;
        slip(s) = 0.5 * limit;
    }
}

fn main() {}

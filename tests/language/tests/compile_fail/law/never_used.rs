use stickslip::friction_law;

friction_law! {
    pub struct Rubber {
        param limit: N;
        param decay: s/m;
        stick = limit;
        slip(s) = 0.5 * limit;
    }
}

fn main() {}

use stickslip::friction_law;

friction_law! {
    pub struct Rubber {
        param limit: N;
        stick = limit;
        slip(s) = if s > 1.0 { limit } else { 0.5 * limit };
    }
}

fn main() {}

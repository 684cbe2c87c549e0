use stickslip::friction_law;

friction_law! {
    pub struct Rubber {
        param limit: N;
        stick = limit;
    }
}

fn main() {}

use stickslip::friction_law;

friction_law! {
    pub struct Rubber {
        param limit: N;
        stick = limit;
        slip(s) = limit * signum(s);
    }
}

fn main() {}

use stickslip::friction_law;

friction_law! {
    pub struct Rubber {
        param limit: N;
        param viscous: N*s/m;
        stick = limit;
        slip(s) = limit + viscous * s * s;
    }
}

fn main() {}

use stickslip::friction_law;

friction_law! {
    pub struct Weakening {
        param limit: N where limit >= 0.0;
        param decay[2]: s/m;
        stick = limit;
        slip(s) = limit / (1.0 + decay * s);
    }
}

fn main() {}

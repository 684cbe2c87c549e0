use stickslip::{friction_law, model};

friction_law! {
    pub struct Dry {
        param level: N where level >= 0.0;
        stick = level;
        slip(s) = level;
    }
}

model! {
    pub struct Sledge {
        state x: m = 1.0;
        state v: m/s = 0.0;
        param m: kg = 1.0 where m > 0.0;
        param rough: N = 1.0 where rough >= 0.0;
        friction F: N = Dry { level: rough } opposing v;
        dx/dt = v;
        der(v) = F / m;
    }
}

fn main() {}

use stickslip::model;

struct Rubber<D> {
    limit: D,
}

model! {
    pub struct Belt {
        state v = 0.0;
        friction F = Rubber { limit: 1.0 } opposing v;
        let push = 2.0 * F;
        der(v) = push;
    }
}

fn main() {}

use stickslip::model;
use stickslip_models::friction::Weakening;

model! {
    pub struct Belt {
        state x: m = 1.0;
        state v: m/s = 0.0;
        param mass: kg = -1.0 where mass > 0.0;
        param k: N/m = 1.0;
        param spare: N = 1.0;
        param v_dr: mm/s = 200.0;
        friction F: N = Weakening { limit: 1.0, decay: 3.0 } opposing v - v_dr;
        der(x) = x;
        der(v) = (F - kk * x) / mass;
    }
}

fn main() {}

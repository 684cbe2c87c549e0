use stickslip::model;
use stickslip_models::friction::Weakening;

model! {
    pub struct Belt {
        state x [m] = 1.0;
        state v: m/s = 0.0;
        param m: kg = 1.0 where m > 0.0;
        param k: N/m = 1.0 where k > 0.0;
        param v_dr: m/s = 0.2;
        param F_s: N = 1.0 where F_s >= 0.0;
        param delta: s/m = 3.0;
        friction F: N = Weakening { limit: F_s, decay: delta } opposing v - v_dr;
        let spring = k * x;
        der(x) = v;
        der(v) = (F - spring) / m;
    }
}

fn main() {}

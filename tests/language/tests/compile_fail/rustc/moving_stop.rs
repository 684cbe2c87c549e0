//! A law stops at a parameter, and the model gives it what changes along a motion.

use stickslip::model;
use stickslip_models::friction::Jenkins;

model! {
    struct Pressed {
        state x: m = 0.0;
        state v: m/s = 0.0;
        state z: N = 0.0;
        param k: N/m = 1.0;
        param F_c: N = 1.0;
        param m: kg = 1.0;
        let limit = F_c + k * x;
        friction F: N = Jenkins { stiffness: k, level: limit } opposing v with z;
        der(x) = v;
        der(v) = (F - k * x) / m;
    }
}

fn main() {}

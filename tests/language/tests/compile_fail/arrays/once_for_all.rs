//! Mistakes inside a loop, each told once.

use stickslip::model;

model! {
    pub struct Chain {
        state x[3]: m = 0.0;
        state v[3]: m/s = 0.0;
        param k: 1/s^2 = 1.0 where k > 0.0;
        for i in 0..3 {
            let spring[i] = k * y[i];
            der(x[i]) = v[i] * 2 + q;
            der(v[i]) = spring[i] + k * v[i];
        }
    }
}

fn main() {}

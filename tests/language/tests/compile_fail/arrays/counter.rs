//! A counter that has another meaning, and a loop that does not begin.

use stickslip::model;

model! {
    pub struct Chain {
        state x[3]: m = 0.0;
        state v[3]: m/s = 0.0;
        param k: 1/s^2 = 1.0 where k > 0.0;
        param i: 1/s = 1.0;
        for i in 0..3 {
            der(x[i]) = v[i];
        }
        for j in 3..0 {
            der(v[j]) = -k * x[j] - i * v[j];
        }
    }
}

fn main() {}

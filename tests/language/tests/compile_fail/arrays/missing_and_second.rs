//! One end without an equation, the other with two.

use stickslip::model;

model! {
    pub struct Chain {
        state x[3]: m = 0.0;
        state v[3]: m/s = 0.0;
        param k: 1/s^2 = 1.0 where k > 0.0;
        for i in 0..3 {
            der(x[i]) = v[i];
        }
        der(v[0]) = -k * x[0];
        for i in 0..2 {
            der(v[i]) = k * (x[i + 1] - 2 * x[i]);
        }
    }
}

fn main() {}

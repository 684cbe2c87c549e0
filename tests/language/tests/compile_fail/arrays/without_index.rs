//! An array where one of its elements is meant, and an index where there is none.

use stickslip::model;

model! {
    pub struct Chain {
        state x[3]: m = 0.0;
        state v[3]: m/s = 0.0;
        param k: 1/s^2 = 1.0 where k > 0.0;
        for i in 0..3 {
            der(x[i]) = v;
            der(v[i]) = -k[i] * x[i];
        }
    }
}

fn main() {}

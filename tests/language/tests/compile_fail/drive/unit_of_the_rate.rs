//! A rate that is no angular frequency.

use stickslip::model;

model! {
    pub struct Swing {
        state x: m = 0.0;
        state v: m/s = 0.0;
        param omega: 1/s = 2.0 where omega > 0.0;
        param period: s = 3.0 where period > 0.0;
        param load: m/s^2 = 1.0;
        drive phi at omega * period;
        der(x) = v;
        der(v) = load * cos(phi) - omega * omega * x;
    }
}

fn main() {}

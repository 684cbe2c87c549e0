//! A force that is not the same after a turn of the phase.

use stickslip::model;

model! {
    pub struct Swing {
        state x = 0.0;
        state v = 0.0;
        param omega = 2.0 where omega > 0.0;
        drive phi at omega;
        let slow = cos(0.5 * phi);
        der(x) = v;
        der(v) = slow - x + exp(-phi);
    }
}

fn main() {}

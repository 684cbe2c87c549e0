//! Two drives, and one of them at a rate that changes with the motion.

use stickslip::model;

model! {
    pub struct Swing {
        state x = 0.0;
        state v = 0.0;
        param omega = 2.0 where omega > 0.0;
        drive phi at omega * x;
        drive psi at 3 * omega;
        der(x) = v;
        der(v) = cos(phi) + cos(psi) - x;
    }
}

fn main() {}

use stickslip::model;
use stickslip_models::friction::Dahl;
use stickslip_models::press::Rigid;

model! {
    pub struct Bouncer {
        state y = 1.0;
        state v = 0.0;
        state w = 0.0;
        state z = 0.0;
        param mu = 0.3;
        press R = Rigid { restitution: 0.8 } closing y;
        friction F = Dahl { stiffness: 10.0, level: 0.1 + mu * R } opposing w with z;
        der(y) = v;
        der(v) = R - 1.0;
        der(w) = F;
    }
}

fn main() {}

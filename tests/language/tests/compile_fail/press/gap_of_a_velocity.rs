use stickslip::model;
use stickslip_models::press::Compliant;

model! {
    pub struct Bouncer {
        state y: m = 1.0;
        state v: m/s = 0.0;
        param mass: kg = 1.0 where mass > 0.0;
        param k: N/m = 1.0 where k > 0.0;
        param c: N*s/m = 0.1 where c >= 0.0;
        press N: N = Compliant { stiffness: k, damping: c } closing y + v * mass / c;
        der(y) = v;
        der(v) = N / mass - v * c / mass;
        press P: N = Compliant { stiffness: k, damping: c } closing y - N / k;
        let both = N + P;
    }
}

fn main() {}

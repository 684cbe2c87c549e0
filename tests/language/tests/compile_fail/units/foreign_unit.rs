use stickslip::model;

model! {
    pub struct Oscillator {
        state angle: rad = 1.0;
        state rate: rad/s = 0.0;
        param inertia: kg*m^2 = 1.0;
        param torque: Nm = 1.0;
        der(angle) = rate;
        der(rate) = -torque * sin(angle) / inertia;
    }
}

fn main() {}

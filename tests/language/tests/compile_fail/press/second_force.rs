use stickslip::press_law;

press_law! {
    pub struct Wall {
        param stiffness: N/m where stiffness > 0.0;
        force(d, v) = stiffness * max(d, 0.0);
        force(w) = stiffness;
    }
}

fn main() {}

use stickslip::press_law;

press_law! {
    pub struct Spring {
        param stiffness: N/m where stiffness > 0.0;
        param damping: N*s/m where damping >= 0.0;
        force(d, v) = stiffness * d + damping * v;
        restitution(w) = 0.5;
    }
}

fn main() {}

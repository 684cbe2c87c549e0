use stickslip_models::BeltOscillator;

fn main() {
    let _ = BeltOscillator::v_dir;
}

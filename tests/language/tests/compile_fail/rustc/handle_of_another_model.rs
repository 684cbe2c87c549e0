use stickslip::model::ParamId;
use stickslip_models::{BeltOscillator, BeltPair};

fn main() {
    let _: ParamId<BeltOscillator> = BeltPair::v_dr;
}

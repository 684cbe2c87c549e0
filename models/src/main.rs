//! The program `stickslip`.

use stickslip_models::{BeltOscillator, BeltPair, DrillString, VanDerPol};

stickslip::app!(VanDerPol, BeltOscillator, BeltPair, DrillString);

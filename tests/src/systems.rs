//! The reference systems, compiled here once for all tests.

use stickslip::study::System;
use stickslip_models::{BeltOscillator, BeltPair, DrillString, VanDerPol};

/// All four of them; without optimisation, whoever uses one of these models shares what is compiled for this.
#[must_use]
pub fn reference_systems() -> [System; 4] {
    [
        System::of::<VanDerPol, _>(),
        System::of::<BeltOscillator, _>(),
        System::of::<BeltPair, _>(),
        System::of::<DrillString, _>(),
    ]
}

//! The reference systems as they answer questions: compiled here once, for the program, the report and all tests.

use stickslip::study::System;

use crate::{BeltOscillator, BeltPair, BristleOscillator, DrillString, ForcedBelt, VanDerPol};

/// [`VanDerPol`].
#[must_use]
#[inline(never)]
pub fn van_der_pol() -> System {
    System::of::<VanDerPol, _>()
}

/// [`BeltOscillator`].
#[must_use]
#[inline(never)]
pub fn belt_oscillator() -> System {
    System::of::<BeltOscillator, _>()
}

/// [`BeltPair`].
#[must_use]
#[inline(never)]
pub fn belt_pair() -> System {
    System::of::<BeltPair, _>()
}

/// [`DrillString`].
#[must_use]
#[inline(never)]
pub fn drill_string() -> System {
    System::of::<DrillString, _>()
}

/// [`BristleOscillator`].
#[must_use]
#[inline(never)]
pub fn bristle_oscillator() -> System {
    System::of::<BristleOscillator, _>()
}

/// [`ForcedBelt`].
#[must_use]
#[inline(never)]
pub fn forced_belt() -> System {
    System::of::<ForcedBelt, _>()
}

/// Those of the thesis.
#[must_use]
pub fn of_the_thesis() -> [System; 4] {
    [
        van_der_pol(),
        belt_oscillator(),
        belt_pair(),
        drill_string(),
    ]
}

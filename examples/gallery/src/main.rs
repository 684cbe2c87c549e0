//! Published systems with dry friction, one a file, each held against something independent.
#![forbid(unsafe_code)]

mod blade;
mod bowed_string;
mod burridge_knopoff;
mod clutch;
mod den_hartog;
mod feeny_moon;
mod froude;
mod isolator;
mod long_drill_string;
mod mass_on_belt;
mod popp;
mod positioning;
mod rotor;
mod spring_slider;
mod squeal;
mod two_blocks;

#[cfg(test)]
mod asked;
#[cfg(test)]
mod reference;

use blade::Blade;
use bowed_string::BowedString;
use burridge_knopoff::BurridgeKnopoff;
use clutch::Clutch;
use den_hartog::DenHartog;
use feeny_moon::FeenyMoon;
use froude::FroudePendulum;
use isolator::Isolator;
use long_drill_string::LongDrillString;
use mass_on_belt::MassOnBelt;
use popp::PoppOscillator;
use positioning::Positioning;
use rotor::Rotor;
use spring_slider::SpringSlider;
use squeal::Squeal;
use two_blocks::TwoBlocks;

stickslip::app!(
    Squeal,
    PoppOscillator,
    BurridgeKnopoff,
    LongDrillString,
    TwoBlocks,
    Positioning,
    Isolator,
    Blade,
    SpringSlider,
    BowedString,
    DenHartog,
    Clutch,
    Rotor,
    MassOnBelt,
    FroudePendulum,
    FeenyMoon,
);

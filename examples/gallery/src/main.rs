//! Published systems with dry friction, one a file, each held against something independent.
#![forbid(unsafe_code)]

mod blade;
mod bouncing_ball;
mod bouncing_bit;
mod bowed_string;
mod burridge_knopoff;
mod clutch;
mod den_hartog;
mod feeny_moon;
mod friction_beam;
mod froude;
mod impact_oscillator;
mod isolator;
mod jointed_chain;
mod lifting_squeal;
mod long_drill_string;
mod mass_on_belt;
mod popp;
mod positioning;
mod relief_valve;
mod rotor;
mod spring_slider;
mod squeal;
mod two_blocks;
mod woodpecker;

#[cfg(test)]
mod asked;
#[cfg(test)]
mod balance;
#[cfg(test)]
mod reference;

use blade::Blade;
use bouncing_ball::BouncingBall;
use bouncing_bit::BouncingBit;
use bowed_string::BowedString;
use burridge_knopoff::BurridgeKnopoff;
use clutch::Clutch;
use den_hartog::DenHartog;
use feeny_moon::FeenyMoon;
use friction_beam::FrictionBeam;
use froude::FroudePendulum;
use impact_oscillator::ImpactOscillator;
use isolator::Isolator;
use jointed_chain::JointedChain;
use lifting_squeal::LiftingSqueal;
use long_drill_string::LongDrillString;
use mass_on_belt::MassOnBelt;
use popp::PoppOscillator;
use positioning::Positioning;
use relief_valve::ReliefValve;
use rotor::Rotor;
use spring_slider::SpringSlider;
use squeal::Squeal;
use two_blocks::TwoBlocks;
use woodpecker::Woodpecker;

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
    ImpactOscillator,
    BouncingBall,
    ReliefValve,
    Woodpecker,
    BouncingBit,
    LiftingSqueal,
    JointedChain,
    FrictionBeam,
);

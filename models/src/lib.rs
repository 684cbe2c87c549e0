//! The physics: reference systems, the library of friction laws, closed-form solutions.

pub mod belt_oscillator;
pub mod belt_pair;
pub mod bristle_oscillator;
pub mod closed_form;
pub mod drill_string;
pub mod forced_belt;
pub mod friction;
pub mod press;
#[cfg(feature = "app")]
pub mod reproduce;
#[cfg(feature = "app")]
pub mod systems;
pub mod van_der_pol;

pub use belt_oscillator::BeltOscillator;
pub use belt_pair::BeltPair;
pub use bristle_oscillator::BristleOscillator;
pub use drill_string::DrillString;
pub use forced_belt::ForcedBelt;
pub use van_der_pol::VanDerPol;

/// Keeps the README's code true.
#[cfg(all(doctest, feature = "app"))]
#[doc = include_str!("../../README.md")]
struct Readme;

/// Keeps the tutorial's code true.
#[cfg(all(doctest, feature = "app"))]
#[doc = include_str!("../../docs/tutorial.md")]
struct Tutorial;

#![doc = include_str!("../README.md")]
//!
//! # Architecture
//!
//! The path of the data is the order of the modules; each imports only from those above it:
//!
//! | modules | what lives there |
//! |---|---|
//! | [`scalar`], [`math`], [`suggest`] | numbers that carry derivatives, intervals, nearest names |
//! | [`mod@model`], [`friction`], [`press`], [`memory`] | what [`model!`], [`friction_law!`] and [`press_law!`] make of a declaration |
//! | [`field`] | the vector field: smoothed, or exact with its sticking forces; its derivatives, its work |
//! | [`integrate`] | steps: explicit, implicit, in closed form where a field is linear; events |
//! | [`flow`] | where a motion is after a time, how that depends on where it began; saltation |
//! | [`motion`] | the joint: from here on, no model and no number of states is known any more |
//! | [`poincare`], [`lyapunov`], [`harmonics`] | points of motions on sections, exponents, amplitudes and phases |
//! | [`continuation`] | zero problems, their branches, named monitors, one walk that locates, accounts and ends |
//! | [`bifurcation`] | multipliers, and the monitors made of them |
//! | [`equilibrium`], [`shooting`], [`curve`] | equilibria, periodic orbits, bifurcations in two parameters |
//! | [`study`] | what is asked and answered: for programs, the place to begin |
//! | `reduce` | small structures of large matrices, for `structure` lines (feature `reduce`) |
//! | `report`, `app` | figures and tables; the program (feature `app`) |
//!
//! Below [`motion`] all is generic over the model and its number of states, and no step touches the heap; above it all
//! is compiled once, in this crate, whatever is declared.
#![forbid(unsafe_code)]
#![deny(missing_docs)]

extern crate self as stickslip;

#[cfg(feature = "app")]
pub mod app;
pub mod bifurcation;
pub mod continuation;
pub mod curve;
#[doc(hidden)]
pub mod declared;
pub mod equilibrium;
pub mod field;
pub mod flow;
pub mod friction;
pub mod harmonics;
pub mod integrate;
mod linear;
pub mod lyapunov;
pub mod math;
pub mod memory;
pub mod model;
pub mod motion;
pub mod poincare;
pub mod press;
#[cfg(feature = "reduce")]
pub mod reduce;
#[cfg(feature = "app")]
pub mod report;
pub mod scalar;
pub mod shooting;
pub mod study;
pub mod suggest;
mod words;

#[cfg(test)]
mod examples;

pub use num_dual::DualSVec64;
#[doc = include_str!("../docs/friction_law.md")]
pub use stickslip_macros::friction_law;
#[doc = include_str!("../docs/model.md")]
pub use stickslip_macros::model;
#[doc = include_str!("../docs/press_law.md")]
pub use stickslip_macros::press_law;

/// Defines the `main` of a program that studies the given models: `stickslip::app!(ModelA, ModelB);`.
#[cfg(not(feature = "app"))]
#[macro_export]
macro_rules! app {
    ($($models:tt)*) => {
        compile_error!("`app!` needs the feature `app`: write `stickslip = { version = \"...\", features = [\"app\"] }`");
    };
}

//! Periodic motions of systems with dry friction: declared once, exact or smoothed, shot, followed and judged.
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
pub mod integrate;
mod linear;
pub mod lyapunov;
pub mod math;
pub mod memory;
pub mod model;
pub mod motion;
pub mod poincare;
#[cfg(feature = "app")]
pub mod report;
pub mod scalar;
#[cfg(feature = "app")]
mod serial;
pub mod shooting;
pub mod study;
pub mod suggest;

#[cfg(test)]
mod examples;

pub use num_dual::DualSVec64;
#[doc = include_str!("../docs/friction_law.md")]
pub use stickslip_macros::friction_law;
#[doc = include_str!("../docs/model.md")]
pub use stickslip_macros::model;

/// Defines the `main` of a program that studies the given models: `stickslip::app!(ModelA, ModelB);`.
#[cfg(not(feature = "app"))]
#[macro_export]
macro_rules! app {
    ($($models:tt)*) => {
        compile_error!("`app!` needs the feature `app`: write `stickslip = { version = \"...\", features = [\"app\"] }`");
    };
}

//! Whole studies of declared models: what is asked, how it is answered, and what the answer holds.
//!
//! A [`Case`] says what is asked, an [`Entry`] is a model that answers, whatever its number of states; records are the
//! answers, free of type parameters, for programs, tables and figures.

#[cfg(feature = "app")]
pub mod app;
mod branch;
mod case;
mod choice;
mod counterpart;
mod declared;
mod ends;
mod entry;
mod equilibria;
mod equilibrium;
mod orbit;
pub mod predict;
#[cfg(feature = "app")]
pub mod report;
mod seed;
mod special;
pub mod trade;
mod trajectory;

pub use branch::{BranchRecord, Ended};
pub use case::{Along, Case, Dynamics};
pub use choice::{Choice, choose};
pub use ends::{End, TradeRecord};
pub use entry::{Entry, StudyError, entry};
pub use equilibrium::{EquilibriaRecord, EquilibriumRecord, Extent, SpecialEquilibrium};
pub use orbit::OrbitRecord;
pub use special::Special;
pub use trajectory::Trajectory;

/// Defines the `main` of a program that studies the given models: `stickslip::app!(ModelA, ModelB);`.
#[cfg(not(feature = "app"))]
#[macro_export]
macro_rules! app {
    ($($model:ty),+ $(,)?) => {
        compile_error!("`app!` needs the feature `app`: write `stickslip = { version = \"...\", features = [\"app\"] }`");
    };
}

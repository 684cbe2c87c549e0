//! Whole studies of declared models: what is asked, how it is answered, and what the answer holds.
//!
//! A [`Case`] says what is asked, a [`System`] is a model that answers, whatever its number of states; records are the
//! answers, free of type parameters, for programs, tables and figures.

mod atlas;
mod branch;
mod case;
mod characteristic;
mod choice;
mod counterpart;
mod curve;
mod declared;
mod diagram;
mod ended;
mod ends;
mod error;

mod equilibria;
mod equilibrium;
mod follow;
mod hysteresis;
mod modes;
mod orbit;
mod parallel;
pub mod predict;
mod section;
mod seed;
mod sought;
mod special;
mod specimen;
mod system;
pub mod trade;
mod trajectory;

pub use branch::BranchRecord;
pub use case::{Along, Beginning, Case, Dynamics, Switch};
pub use characteristic::Characteristic;
pub use choice::{Choice, choose};
pub use curve::{CurveFinding, CurvePointRecord, CurveRecord, CurveScope, SpecialCurvePoint};
pub use diagram::{
    Diagram, DiagramRecord, Known, Motion, Seen, Slice, Sweep, SweepRecord, Watcher,
};
pub use ended::Ended;
pub use ends::{End, TradeRecord};
pub use equilibrium::{EquilibriaRecord, EquilibriumRecord, Extent, SpecialEquilibrium};
pub use error::StudyError;
pub use hysteresis::Hysteresis;
pub use orbit::{CertifiedOrbit, OrbitRecord};
pub use parallel::{parallel, parallel_on};
pub use section::Span;
pub use special::Special;
pub use specimen::{Remembering, Shown, Specimen};
pub use system::System;
pub use trajectory::Trajectory;

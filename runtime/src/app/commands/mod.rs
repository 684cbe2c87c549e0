//! What the program does, one folder for each command.

pub(super) mod attractors;
pub(super) mod branch;
pub(super) mod curve;
pub(super) mod diagram;
pub(super) mod equilibria;
pub(super) mod laws;
pub(super) mod map;
pub(super) mod merge;
pub(super) mod models;
pub(super) mod needs;
pub(super) mod orbit;
#[cfg(feature = "reduce")]
pub(super) mod reduce;
pub(super) mod reproduce;
pub(super) mod simulate;
pub(super) mod status;
pub(super) mod trade;

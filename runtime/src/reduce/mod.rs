//! Structures of many unknowns, reduced to the modes that a model of a few contacts needs.
//!
//! Mass and stiffness come from a finite element program, points are named where something is to happen, and what is
//! left is a [`Structure`]: frequencies, damping and the shapes at these points, a small text that
//! `structure beam = "beam.structure";` reads. See Craig, Kurdila, *Fundamentals of Structural Dynamics*, ch. 17, and
//! for contacts without mass Monjaraz-Tec, Kohlmann, Schwarz, Hartung, Gross and Krack, MSSP 174 (2022) 109101.

mod assemble;
mod coefficients;
mod error;
mod factor;
mod krylov;
mod method;
mod modes;
mod pencil;
mod place;
mod projection;
mod read;
mod reduction;
mod residual;
mod structure;

pub use coefficients::{Coefficients, Source};
pub use error::ReduceError;
pub use method::Method;
pub use pencil::Pencil;
pub use place::{Place, Point};
pub use read::{place_rows, read};
pub use reduction::reduce;
pub use structure::{Mode, Scale, Structure};

#[cfg(test)]
mod tests;

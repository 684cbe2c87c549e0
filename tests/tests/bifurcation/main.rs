//! Branches of orbits, and what happens on them.

mod alike;
mod atlas;
mod bands;
mod branch;
mod canard;
mod curves;
mod diagram;
mod edge;
mod escapement;
mod family;
mod flips;
mod folds;
mod homoclinic;
mod mirrored;
mod orbits;
mod scales;
mod symmetric;
mod symmetry;
mod unstable;

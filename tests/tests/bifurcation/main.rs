//! Branches, what happens on them, and where else motions end.

mod alike;
mod atlas;
mod bands;
mod borders;
mod branch;
mod canard;
mod carriage;
mod carried;
mod corner;
mod curves;
mod diagram;
mod ends;
mod equilibria;
mod equilibrium_curves;
mod family;
mod folds;
mod grazing;
mod kinked;
mod margins;
mod mirrored;
mod onset;
mod orbits;
mod scales;
mod still;
mod symmetry;
mod unstable;

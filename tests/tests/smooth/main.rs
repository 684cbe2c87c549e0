//! Smooth and smoothed motions: their flow, their layers, and the orbits that are shot for.

mod driven;
mod flow;
mod followed;
mod hunting;
mod layers;
mod memory_laws;
mod metamorphic;
mod oscillators;
mod response;
mod shooting;
mod stops;
mod strobes;

//! Motions with set-valued friction.

mod audit;
mod closed_form;
mod derivatives;
mod enclosed_cycles;
mod extents;
mod ground;
mod henon;
mod late;
mod levers;
mod linear;
mod metamorphic;
mod properties;
mod reach;
mod reference;
mod stiff;

//! Motions with set-valued friction.

mod audit;
mod closed_form;
mod derivatives;
mod henon;
mod metamorphic;
mod properties;
mod reference;

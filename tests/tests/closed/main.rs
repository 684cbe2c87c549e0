//! Dry contacts in closed form: one element, one mass.

mod hartog;
mod jenkins;

//! Dry contacts in closed form: one element, one mass.

mod hartog;
mod held;
mod jenkins;
mod stacked;

//! Periodic orbits of a case: where they are looked for, and what is reported of them.

mod found;
mod record;
mod seed;
mod sought;

pub use record::{CertifiedOrbit, Held, OrbitRecord};
pub(in crate::study) use sought::Sought;

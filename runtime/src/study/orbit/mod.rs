//! Periodic orbits of a case: where they are looked for, and what is reported of them.

mod found;
mod held;
mod record;
mod seed;
mod sought;

pub use held::Held;
pub use record::{Beside, CertifiedOrbit, OrbitRecord};
pub(in crate::study) use sought::Sought;

//! The library of laws of contacts that press and let go, one a file.
//!
//! Each names its formula, its symbols and its source; units stand at the parameters, where N is the contact's force and
//! m its gap. No law pulls: where its formula would, the contact is open.

mod compliant;
mod hertz;
mod hunt_crossley;

pub use compliant::Compliant;
pub use hertz::Hertz;
pub use hunt_crossley::HuntCrossley;

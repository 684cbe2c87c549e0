//! The library of laws of contacts that press and let go, one a file.
//!
//! Each names its formula, its symbols and its source; units stand at the parameters, where N is the contact's force and
//! m its gap. No law pulls: where its formula would, the contact is open.

mod compliant;
mod hertz;
mod hunt_crossley;
mod rigid;

pub use compliant::Compliant;
pub use hertz::Hertz;
pub use hunt_crossley::HuntCrossley;
pub use rigid::Rigid;

use stickslip::specimen;
use stickslip::study::{Specimen, Strike};

/// Every compliant law of the library, with typical values of its parameters and a strike.
#[must_use]
pub fn library() -> Vec<Specimen<dyn Strike>> {
    vec![
        specimen!(Compliant {
            stiffness: 1e6,
            damping: 200.0,
        } striking 1e-4 at 0.1),
        specimen!(Hertz {
            load: 100.0,
            depth: 1e-5,
        } striking 2e-5 at 0.1),
        specimen!(HuntCrossley {
            load: 100.0,
            depth: 1e-5,
            exponent: 1.5,
            damping: 0.5,
        } striking 2e-5 at 0.1),
    ]
}

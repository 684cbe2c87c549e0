//! What is asked of a system: at which parameters, along what, with which friction, on which section.

mod case;
mod choice;
mod dynamics;
mod section;

pub use case::{Along, Beginning, Case, Switch};
pub use choice::{Choice, choose};
pub use dynamics::Dynamics;
pub use section::Span;

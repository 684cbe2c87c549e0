//! Error against cost: what each smoothing of a model with friction costs and what it gets wrong (thesis 3.2, 4.2).
//!
//! The exact orbit is the truth. Copies are found near it, followed in their size where Newton does not reach them, and
//! counted while their orbit crosses the section as often as the exact one does.

mod accuracy;
mod copy;
mod ends;
mod fit;
mod lost;
mod measure;
mod precision;
mod record;
mod shoot;

pub use crate::study::error::TradeError;
pub use ends::{End, TradeRecord};
pub use fit::Fit;
pub use lost::Lost;
pub use record::{
    Cost, Curve, Finding, Need, Point, Precision, PrecisionPoint, Scope, Setting, Trade, Truth,
    Watch,
};

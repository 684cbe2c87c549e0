//! Error against cost: what each smoothing of a model with friction costs and what it gets wrong (thesis 3.2, 4.2).
//!
//! The exact orbit is the truth. Copies are found near it, followed in their size where Newton does not reach them, and
//! counted while their orbit crosses the section as often as the exact one does. Each copy is an item of a list by itself:
//! where it needs the next finer one, it finds that again.

mod accuracy;
mod copy;
mod ends;
mod fit;
mod gather;
mod lost;
mod precision;
mod record;
mod shoot;
mod task;

pub use crate::study::error::TradeError;
pub use ends::{End, TradeRecord};
pub use fit::Fit;
pub use record::{
    Cost, Curve, Need, Point, Precision, PrecisionPoint, Scope, Setting, Trade, Truth,
};
pub use task::{Copied, Exact, Part};

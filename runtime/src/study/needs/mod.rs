//! The least that answers a question: what of a model it needs, what may be written away, and what it lacks.
//!
//! The answer is that of `orbit`: the period, and how far each state reaches; of a structure, how far its points are
//! displaced, since its modes are coordinates that nobody has asked for. It is judged at one place, or at both ends of a
//! range and wherever on the branch between them something is largest.

mod answer;
mod contacts;
mod lacks;
mod modes;
mod parameters;
mod record;
mod sensitivity;
mod stage;
mod thin;
mod topic;

pub use contacts::{ContactNeed, Role};
pub use lacks::Lack;
pub use modes::{ModesNeed, ModesPoint};
pub use parameters::ParameterNeed;
pub use record::NeedsRecord;
pub use stage::Placed;
pub use topic::Topic;

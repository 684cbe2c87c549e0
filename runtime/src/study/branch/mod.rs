//! Branches of periodic orbits, with those that leave them.

mod atlas;
mod follow;
mod meeting;
mod record;
mod special;

pub(in crate::study) use atlas::Hopf;
pub use record::BranchRecord;
pub use special::Special;
pub(in crate::study) use special::numbered;

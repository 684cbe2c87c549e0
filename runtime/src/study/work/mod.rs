//! Work as a list: items that depend on nothing but the question, so that any number of threads, shards, orders and
//! interruptions leads to the same answer.

mod list;
mod parallel;
mod rows;
mod share;

pub use list::{Item, List, Watch};
pub use parallel::{parallel, parallel_on};
pub use rows::Rows;
pub use share::Share;

//! A question asked at every node of a grid of two parameters, each node by itself: nothing is taken from a neighbour, so
//! that no order of the nodes can change an answer.

mod cell;
mod grid;
mod question;

pub use cell::Cell;
pub use grid::{Grid, MapRecord};
pub use question::{Asked, Quantity};

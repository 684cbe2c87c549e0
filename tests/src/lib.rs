//! Shared by the tests: the reference systems by hand, derivatives by dual numbers, random numbers.

pub mod hand_written;
pub mod lanes;
pub mod random;

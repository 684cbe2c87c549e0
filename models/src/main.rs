//! The program `stickslip`.
fn main() {}

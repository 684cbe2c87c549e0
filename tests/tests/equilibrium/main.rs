//! Where motions end, how that changes along a parameter, and what begins there.

mod curves;
mod equilibria;
mod margins;
mod onset;
mod scales;

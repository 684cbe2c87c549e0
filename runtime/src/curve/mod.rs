//! Curves of bifurcations of periodic orbits in two design variables.
//!
//! A curve is a branch of the continuation core like any other: its zero problem holds the equations of
//! the orbit and one more, the condition that makes the orbit special, with the first design variable p
//! among the unknowns and the second, q, as the one along which it is followed.

mod codimension;
mod condition;
mod critical;
mod follow;
mod follow_graze;
mod isola;
mod plane;
mod point;

pub use condition::Condition;
pub use critical::{CriticalProblem, CriticalShot};
pub use follow::{Curve, follow};
pub use follow_graze::{GrazingPoint, follow_graze};
pub use plane::Plane;
pub use point::CurvePoint;

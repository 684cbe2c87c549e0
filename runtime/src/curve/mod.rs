//! Curves of bifurcations of periodic orbits and of equilibria in two design variables.
//!
//! A curve is a branch of the continuation core like any other: its zero problem holds the equations of
//! the orbit or equilibrium and one more, the condition that makes it special, with the first design variable p
//! among the unknowns and the second, q, as the one along which it is followed.

mod codimension;
mod codimension_equilibrium;
mod condition;
mod critical;
mod follow;
mod follow_border;
mod follow_equilibrium;
mod isola;
mod plane;
mod point;
mod subject;

pub use condition::Condition;
pub use critical::{Critical, CriticalProblem};
pub use follow::{Curve, follow};
pub use follow_border::{BorderPoint, follow_border};
pub use follow_equilibrium::follow_equilibrium;
pub use plane::Plane;
pub use point::{CriticalEquilibrium, CurvePoint};
pub use subject::{Beside, Subject};

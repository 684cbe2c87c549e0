//! Whole studies of declared models: what is asked, how it is answered, and what the answer holds.
//!
//! ```
//! use stickslip::study::{Case, Kind, System};
//!
//! stickslip::friction_law! {
//!     /// Friction that falls with the speed.
//!     pub struct Falling {
//!         param level where level > 0.0;
//!         stick = level;
//!         slip(s) = level * exp(-s / 2);
//!     }
//! }
//!
//! stickslip::model! {
//!     /// A mass on a belt.
//!     pub struct Mass {
//!         state x = 0.0;
//!         state v = 0.0;
//!         param belt = 0.3 where belt > 0.0;
//!         param damping = 0.2 where damping >= 0.0;
//!         friction F = Falling { level: 1.0 } opposing v - belt;
//!         der(x) = v;
//!         der(v) = F - x - damping * v;
//!     }
//! }
//!
//! let system = System::of::<Mass, _>();
//! let case = Case::of(&Mass::default()).with(Mass::damping, 0.1);
//! let orbit = system.orbit(&case)?;
//! println!("{} at the period {:.9}", orbit.floquet.stability.name(), orbit.period);
//!
//! let along = case.following(Mass::belt, 0.3..6.0);
//! let even = system.equilibria_along(&along)?;
//! // Where the law falls by as much as damping takes: exp(-v/2)/2 = 0.1.
//! assert_eq!(even.special[0].kind, Kind::Hopf);
//! assert!((even.special[0].r - 2.0 * 5.0_f64.ln()).abs() < 1e-9);
//! # Ok::<(), stickslip::study::StudyError>(())
//! ```
//!
//! A [`Case`] says what is asked, a [`System`] is a model that answers, whatever its number of states; records are the
//! answers, free of type parameters, for programs, tables and figures. Each kind of answer has a room of its own, in the
//! order in which they build on each other:
//!
//! | room | what is asked there |
//! |---|---|
//! | `question` | nothing: it says what can be asked |
//! | `law` | the force of a law on its own |
//! | `predict` | what a smoothing would make of an exact orbit |
//! | `system` | whether a case can be asked at all |
//! | `work` | nothing: lists of items, and shares of them |
//! | `motion` | [`System::motion`], [`System::crossings`] |
//! | `equilibria` | [`System::equilibria`], [`System::equilibria_along`], [`System::proofs`] |
//! | `orbit` | [`System::orbit`], [`System::certified_orbit`] |
//! | `branch` | [`System::branch`] |
//! | `curve` | [`System::curve`] |
//! | `diagram` | [`System::diagram`] |
//! | `attractors` | [`System::attractors`] |
//! | `map` | [`System::map`] |
//! | `trade` | [`System::trade`] |
//! | `needs` | [`System::needs`] |

mod attractors;
mod branch;
mod curve;
mod diagram;
mod ended;
mod equilibria;
mod error;
mod label;
mod law;
mod map;
mod motion;
mod needs;
mod orbit;
mod physics;
pub mod predict;
mod question;
mod system;
pub mod trade;
mod unwatched;
mod work;

pub use crate::bifurcation::{Kind, Stability};
pub use crate::field::{Design, Kernel, Smoothing};
pub use crate::poincare::Section;
pub use crate::shooting::OrbitError;
pub use attractors::{
    Attractor, AttractorsRecord, Class, Edge, Fate, Followed, FollowedRecord, Found, Region,
    Sampling, Side, Spot, Survey,
};
pub use branch::{BranchRecord, Special};
pub use curve::{
    CurveFinding, CurvePointRecord, CurveRecord, CurveScope, Curved, SpecialCurvePoint,
};
pub use diagram::{Diagram, DiagramRecord, Motion, Slice, Sweep, SweepRecord};
pub use ended::Ended;
pub use equilibria::{EquilibriaRecord, EquilibriumRecord, Extent, SpecialEquilibrium};
pub use error::StudyError;
pub use law::{Acting, Characteristic, Hysteresis, Shown, Specimen, Strike};
pub use map::{Asked, Cell, Grid, MapRecord, Quantity};
pub use motion::{Envelope, Limits, Trajectory};
pub use nalgebra::Complex;
pub use needs::{
    ContactNeed, Lack, ModesNeed, ModesPoint, NeedsRecord, ParameterNeed, Placed, Role, Topic,
};
pub use orbit::{Beside, CertifiedOrbit, Held, OrbitRecord};
pub use question::{Along, Beginning, Case, Choice, Dynamics, Span, Switch, choose};
pub use system::{News, System};
pub use trade::{End, TradeRecord};
pub use work::{Item, List, Rows, Share, Watch, parallel, parallel_on};

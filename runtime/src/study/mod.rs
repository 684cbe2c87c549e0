//! Whole studies of declared models: what is asked, how it is answered, and what the answer holds.
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
mod orbit;
mod physics;
pub mod predict;
mod question;
mod system;
pub mod trade;
mod work;

pub use attractors::{
    Attractor, AttractorsRecord, Class, Edge, Fate, Found, Region, Sampling, Side, Survey,
};
pub use branch::{BranchRecord, Special};
pub use curve::{
    CurveFinding, CurvePointRecord, CurveRecord, CurveScope, Curved, SpecialCurvePoint,
};
pub use diagram::{
    Diagram, DiagramRecord, Known, Motion, Seen, Slice, Sweep, SweepRecord, Watcher,
};
pub use ended::Ended;
pub use equilibria::{EquilibriaRecord, EquilibriumRecord, Extent, SpecialEquilibrium};
pub use error::StudyError;
pub use law::{Acting, Characteristic, Hysteresis, Shown, Specimen, Strike};
pub use map::{Asked, Cell, Grid, MapRecord, Quantity};
pub use motion::{Envelope, Limits, Trajectory};
pub use orbit::{CertifiedOrbit, Held, OrbitRecord};
pub use question::{Along, Beginning, Case, Choice, Dynamics, Span, Switch, choose};
pub use system::{News, System};
pub use trade::{End, TradeRecord};
pub use work::{Item, List, Share, parallel, parallel_on};

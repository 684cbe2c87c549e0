//! Models of any number of states behind one interface.

use super::branch::BranchRecord;
use super::case::Case;
use super::declared::Declared;
use super::ends::TradeRecord;
use super::equilibrium::{EquilibriaRecord, EquilibriumRecord};
use super::orbit::OrbitRecord;
use super::trade::{Scope, TradeError};
use super::trajectory::Trajectory;
use crate::continuation::Failure;
use crate::flow::FlowError;
use crate::model::{Model, ModelInfo};
use crate::shooting::OrbitError;

/// A declared model that answers a [`Case`].
pub trait Entry: Send + Sync {
    /// The model as data.
    fn info(&self) -> &'static ModelInfo;

    /// Whether the case can be asked at all: at both ends of what is followed.
    ///
    /// # Errors
    /// A parameter is out of its bounds, a smoothing would falsify a law, or there is nothing to follow.
    fn check(&self, case: &Case) -> Result<(), StudyError>;

    /// The motion from the start of the case for the time `time`.
    ///
    /// # Errors
    /// The motion cannot be followed.
    fn motion(&self, case: &Case, time: f64) -> Result<Trajectory, StudyError>;

    /// The periodic orbit that is reached from the start of the case.
    ///
    /// # Errors
    /// None was found.
    fn orbit(&self, case: &Case) -> Result<OrbitRecord, StudyError>;

    /// The equilibria that are found, and for exact dynamics the sets of sticking ones.
    ///
    /// # Errors
    /// None was found.
    fn equilibria(&self, case: &Case) -> Result<Vec<EquilibriumRecord>, StudyError>;

    /// The branch of equilibria along the design variable of the case; `watch` sees each point as it is found.
    ///
    /// # Errors
    /// There is no equilibrium to begin with.
    fn equilibria_along(
        &self,
        case: &Case,
        watch: &mut dyn FnMut(&EquilibriumRecord),
    ) -> Result<EquilibriaRecord, StudyError>;

    /// The branch of orbits along the design variable of the case; `watch` sees each point as it is found.
    ///
    /// # Errors
    /// There is no orbit to begin with.
    fn branch(
        &self,
        case: &Case,
        watch: &mut dyn FnMut(&OrbitRecord),
    ) -> Result<BranchRecord, StudyError>;

    /// Error against cost of every smoothing, near the exact orbit of the case; at both ends if a parameter is followed.
    ///
    /// # Errors
    /// There is no friction, or no exact orbit.
    fn trade(&self, case: &Case, scope: &Scope) -> Result<TradeRecord, StudyError>;
}

/// Why a case has no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StudyError {
    /// The size of a smoothing was to be followed, but there is no smoothing.
    #[error("there is no smoothing whose size could be followed")]
    NothingToSmooth,
    /// A branch was asked for, but not along what.
    #[error("a branch needs a design variable to be followed along")]
    NothingToFollow,
    /// The errors of smoothing cannot be measured.
    #[error(transparent)]
    Trade(#[from] TradeError),
    /// No equilibrium was found.
    #[error(
        "no equilibrium that could be followed was found from {starts} starts; `--start` says where to look first"
    )]
    NoEquilibrium {
        /// From how many places it was looked for.
        starts: usize,
    },
    /// An equilibrium cannot be followed.
    #[error("the equilibrium cannot be followed: {0}")]
    Equilibrium(Failure<FlowError>),
    /// No orbit was found.
    #[error(transparent)]
    Orbit(#[from] OrbitError),
    /// The motion cannot be followed.
    #[error(transparent)]
    Flow(#[from] FlowError),
}

/// The model `M` as an entry; the number of its states is inferred: `entry::<BeltOscillator, _>()`.
#[must_use]
pub fn entry<M: Model<N>, const N: usize>() -> Box<dyn Entry> {
    Box::new(Declared::<M, N>::new())
}

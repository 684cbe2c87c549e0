//! Models of any number of states behind one interface.

use std::ops::ControlFlow;

use super::branch::BranchRecord;
use super::case::Case;
use super::characteristic::Characteristic;
use super::curve::{CurveFinding, CurveRecord, CurveScope};
use super::declared::Declared;
use super::diagram::{Diagram, DiagramRecord, Known, Watcher};
use super::ends::TradeRecord;
use super::equilibrium::{EquilibriaRecord, EquilibriumRecord};
use super::orbit::{CertifiedOrbit, OrbitRecord};
use super::section::{CrossingRecord, Span};
use super::trade::{Finding, Scope, TradeError};
use super::trajectory::Trajectory;
use crate::continuation::Failure;
use crate::equilibrium::{Proof, Unproven};
use crate::flow::{FlowError, Tape};
use crate::model::{Model, ModelInfo};
use crate::poincare::Section;
use crate::shooting::{OrbitError, SwitchError};

/// A declared model that answers a [`Case`].
pub trait Entry: Send + Sync {
    /// The model as data.
    fn info(&self) -> &'static ModelInfo;

    /// Whether the case can be asked at all: at both ends of what is followed.
    ///
    /// # Errors
    /// A parameter is out of its bounds, a smoothing would falsify a law, or there is nothing to follow.
    fn check(&self, case: &Case) -> Result<(), StudyError>;

    /// Shows the law of each contact with its number, at the parameters and the start of the case.
    fn laws(&self, case: &Case, see: &mut dyn FnMut(usize, &dyn Characteristic));

    /// The motion from the start of the case for the time `time`.
    ///
    /// # Errors
    /// The motion cannot be followed.
    fn motion(&self, case: &Case, time: f64) -> Result<Trajectory, StudyError>;

    /// The points at which the motion from the start of the case meets a section.
    ///
    /// # Errors
    /// The motion cannot be followed.
    fn crossings(
        &self,
        case: &Case,
        section: Section,
        span: Span,
    ) -> Result<Vec<CrossingRecord>, StudyError>;

    /// The periodic orbit that is reached from the start of the case.
    ///
    /// # Errors
    /// None was found.
    fn orbit(&self, case: &Case) -> Result<OrbitRecord, StudyError>;

    /// The same orbit with its certificate: how near to it a true orbit is, and only one.
    ///
    /// # Errors
    /// None was found. An orbit that cannot be certified is no error: it comes with the reason.
    fn certified_orbit(&self, case: &Case) -> Result<CertifiedOrbit, StudyError>;

    /// The equilibria that are found, and for exact dynamics the sets of sticking ones.
    ///
    /// # Errors
    /// None was found.
    fn equilibria(&self, case: &Case) -> Result<Vec<EquilibriumRecord>, StudyError>;

    /// For each equilibrium that was found at the case a proof that it exists and is the only one in a box, or why there is
    /// none.
    fn proofs(&self, case: &Case, found: &[EquilibriumRecord]) -> Vec<Result<Proof, Unproven>>;

    /// The branch of equilibria along the design variable of the case; `watch` sees each point as it is found, and may end
    /// the branch there.
    ///
    /// # Errors
    /// There is no equilibrium to begin with.
    fn equilibria_along(
        &self,
        case: &Case,
        watch: &mut dyn FnMut(&EquilibriumRecord) -> ControlFlow<()>,
    ) -> Result<EquilibriaRecord, StudyError>;

    /// The branch of orbits along the design variable of the case; what is on the tape of the same question is not
    /// computed again, and `watch` sees each point as it is found, and may end the branch there.
    ///
    /// # Errors
    /// There is no orbit to begin with.
    fn branch(
        &self,
        case: &Case,
        tape: &Tape<'_>,
        watch: &mut dyn FnMut(&OrbitRecord) -> ControlFlow<()>,
    ) -> Result<BranchRecord, StudyError>;

    /// A special point of that branch, followed in the design variable of the case and another one; what is on the tape
    /// of the same question is not computed again, and `watch` sees each orbit of the branch and each point of
    /// the curve as it is found, and may end either there.
    ///
    /// # Errors
    /// There is no orbit to begin with, or no such point on its branch, or the branch was ended before the curve began.
    fn curve(
        &self,
        case: &Case,
        scope: &CurveScope,
        tape: &Tape<'_>,
        watch: &mut dyn FnMut(CurveFinding<'_>) -> ControlFlow<()>,
    ) -> Result<CurveRecord, StudyError>;

    /// Where the motions of the case meet a section, for many values of its design variable; what is `known` from the
    /// same question is not computed again, and `watch` sees each value, from any thread.
    ///
    /// # Errors
    /// Nothing is followed, or the case cannot be asked.
    fn diagram(
        &self,
        case: &Case,
        diagram: &Diagram,
        known: &Known,
        watch: Watcher<'_>,
    ) -> Result<DiagramRecord, StudyError>;

    /// Error against cost of every smoothing, near the exact orbit of the case; at both ends if a parameter is followed.
    /// `watch` sees what is found at which end as it is found, and may end the trade there.
    ///
    /// # Errors
    /// There is no friction, or no exact orbit.
    fn trade(
        &self,
        case: &Case,
        scope: &Scope,
        watch: &mut dyn FnMut(usize, Finding<'_>) -> ControlFlow<()>,
    ) -> Result<TradeRecord, StudyError>;
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
    /// A driven model never rests.
    #[error(
        "`{model}` has no equilibrium: its drive `{phase}` never stands still; `orbit` finds the motion that answers it"
    )]
    Driven {
        /// The model.
        model: &'static str,
        /// The phase of its drive.
        phase: &'static str,
    },
    /// A law holds any force between its stops while it rests.
    #[error(
        "`{model}` has no equilibrium that stands alone: at rest `{law}` holds any force between its stops; `simulate` \
         shows where a motion comes to rest"
    )]
    NotIsolated {
        /// The model.
        model: &'static str,
        /// The law.
        law: &'static str,
    },
    /// An equilibrium cannot be followed.
    #[error("the equilibrium cannot be followed: {0}")]
    Equilibrium(Failure<FlowError>),
    /// The branch has no such special point.
    #[error("{}", no_special(.wanted.as_deref(), .labels))]
    NoSpecial {
        /// Its label, if one was asked for.
        wanted: Option<String>,
        /// The labels that there are.
        labels: Vec<String>,
    },
    /// The branch of the special point was interrupted; as far as it came.
    #[error("the branch was interrupted before the curve began")]
    Interrupted(Box<BranchRecord>),
    /// A special point that has no curve here.
    #[error(
        "{label} is a {kind} point, and only folds, flips, torus and grazing points can be followed in two parameters"
    )]
    NotFollowed {
        /// Its label.
        label: String,
        /// What it is.
        kind: &'static str,
    },
    /// A curve cannot be begun.
    #[error("the special point cannot be followed: {0}")]
    Curve(Failure<FlowError>),
    /// No orbit was found.
    #[error(transparent)]
    Orbit(#[from] OrbitError),
    /// The equilibrium has no Hopf point on the way.
    #[error(
        "the equilibrium has no Hopf point there from which orbits could be followed: `equilibria` shows what it has"
    )]
    NoHopf,
    /// No orbit begins at the Hopf point.
    #[error("no orbit was found that begins at the Hopf point: {0}")]
    Hopf(SwitchError),
    /// The motion cannot be followed.
    #[error(transparent)]
    Flow(#[from] FlowError),
}

fn no_special(wanted: Option<&str>, labels: &[String]) -> String {
    let there = match labels {
        [] => "the branch has no special point at all".to_owned(),
        labels => format!("the branch has {}", labels.join(", ")),
    };
    match wanted {
        Some(wanted) => format!("there is no special point {wanted}: {there}"),
        None => format!(
            "there is no fold, flip, torus or grazing point to be followed in two parameters: {there}"
        ),
    }
}

/// The model `M` as an entry; the number of its states is inferred: `entry::<BeltOscillator, _>()`.
#[must_use]
pub fn entry<M: Model<N>, const N: usize>() -> Box<dyn Entry> {
    Box::new(Declared::<M, N>::new())
}

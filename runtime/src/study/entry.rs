//! Models of any number of states behind one interface.

use std::marker::PhantomData;

use super::branch::BranchRecord;
use super::case::{Case, Dynamics};
use super::orbit::{OrbitRecord, Sought};
use super::trajectory::{Trajectory, trajectory};
use crate::field::{Design, Kernel, Smoothing};
use crate::flow::{Family, FlowError, SmoothFamily};
use crate::integrate::Tolerance;
use crate::model::{Model, ModelInfo};
use crate::scalar::Inline;
use crate::shooting::{OrbitError, Search};

/// A declared model that answers a [`Case`].
pub trait Entry: Send + Sync {
    /// The model as data.
    fn info(&self) -> &'static ModelInfo;

    /// Whether the case can be asked at all: at both ends of what is followed.
    ///
    /// # Errors
    /// A parameter is out of its bounds, a smoothing would falsify a law, or such dynamics are not available.
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

    /// The branch of orbits along the design variable of the case; `watch` sees each point as it is found.
    ///
    /// # Errors
    /// There is no orbit to begin with.
    fn branch(
        &self,
        case: &Case,
        watch: &mut dyn FnMut(&OrbitRecord),
    ) -> Result<BranchRecord, StudyError>;
}

/// Why a case has no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StudyError {
    /// Exact dynamics were asked for.
    #[error(
        "`{model}` has friction, and its exact dynamics are not available yet: give `--smooth {example}`"
    )]
    ExactNotAvailable {
        /// The model.
        model: &'static str,
        /// A smoothing that suits its laws.
        example: Smoothing,
    },
    /// A branch was asked for, but not along what.
    #[error("a branch needs a design variable to be followed along")]
    NothingToFollow,
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
    Box::new(Declared::<M, N>(PhantomData))
}

struct Declared<M, const N: usize>(PhantomData<fn() -> M>);

impl<M: Model<N>, const N: usize> Declared<M, N> {
    fn smooth(case: &Case) -> Result<SmoothFamily<M, N>, StudyError> {
        if case.dynamics == Dynamics::Exact && !M::INFO.contacts.is_empty() {
            return Err(Self::not_available(case));
        }
        Ok(Self::family(case, case.smoothing()))
    }

    fn family(case: &Case, smoothing: Option<Smoothing>) -> SmoothFamily<M, N> {
        let default = M::default().values();
        let values = Inline::from_fn(|i| {
            let given = case.parameters.get(i).copied();
            given.unwrap_or(default.as_ref()[i])
        });
        SmoothFamily {
            model: M::from_values(values),
            smoothing,
            design: case.along.map_or(Design::None, |along| along.design),
            tolerance: Tolerance::for_accuracy(case.accuracy),
            magnitude: [1.0; N],
        }
    }

    fn not_available(case: &Case) -> StudyError {
        let sign = Smoothing {
            kernel: Kernel::Arctan,
            size: 1e5,
        };
        let bump = Smoothing {
            kernel: Kernel::Quartic,
            size: 1e-2,
        };
        let suits = |smoothing| {
            let family = Self::family(case, Some(smoothing));
            family.at(Self::beginning(case)).is_ok()
        };
        StudyError::ExactNotAvailable {
            model: M::INFO.command,
            example: if suits(sign) { sign } else { bump },
        }
    }

    /// r, as the family counts it, where the case begins.
    fn beginning(case: &Case) -> f64 {
        case.along.map_or(0.0, |along| along.span().0)
    }

    fn start(case: &Case) -> [f64; N] {
        std::array::from_fn(|j| {
            let given = case.start.as_ref().and_then(|start| start.get(j).copied());
            given.unwrap_or(M::INFO.states[j].start)
        })
    }

    fn search(case: &Case) -> Search<N> {
        Search {
            start: Self::start(case),
            period: case.period,
            accuracy: case.accuracy,
            segments: 1,
        }
    }

    fn sought<'a>(
        case: &'a Case,
        family: &'a SmoothFamily<M, N>,
    ) -> Sought<'a, SmoothFamily<M, N>, N> {
        Sought {
            family,
            case,
            search: Self::search(case),
            spelling: |_| None,
        }
    }
}

impl<M: Model<N>, const N: usize> Entry for Declared<M, N> {
    fn info(&self) -> &'static ModelInfo {
        M::INFO
    }

    fn check(&self, case: &Case) -> Result<(), StudyError> {
        let family = Self::smooth(case)?;
        let (from, to) = case.along.map_or((0.0, 0.0), |along| along.span());
        family.at(from)?;
        family.at(to)?;
        Ok(())
    }

    fn motion(&self, case: &Case, time: f64) -> Result<Trajectory, StudyError> {
        let flow = Self::smooth(case)?.at(Self::beginning(case))?;
        Ok(trajectory(&flow, Self::start(case), time)?)
    }

    fn orbit(&self, case: &Case) -> Result<OrbitRecord, StudyError> {
        let family = Self::smooth(case)?;
        let sought = Self::sought(case, &family);
        Ok(sought.record(&sought.orbit(Self::beginning(case))?))
    }

    fn branch(
        &self,
        case: &Case,
        watch: &mut dyn FnMut(&OrbitRecord),
    ) -> Result<BranchRecord, StudyError> {
        let family = Self::smooth(case)?;
        let along = case.along.ok_or(StudyError::NothingToFollow)?;
        Ok(Self::sought(case, &family).branch(along, watch)?)
    }
}

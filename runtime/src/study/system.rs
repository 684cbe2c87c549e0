//! A declared model that answers questions, whatever its type.

use std::fmt;
use std::sync::Arc;

use crate::field::exact::Mode;
use crate::field::{Design, Smoothing};
use crate::flow::FlowError;
use crate::model::{Model, ModelInfo};
use crate::motion::{Enclosure, Family, Flow, Tape};
use crate::shooting::Orbit;
use crate::study::error::StudyError;
use crate::study::law::Acting;
use crate::study::physics::{Of, Physics};
use crate::study::predict::{PredictError, Prediction};
use crate::study::question::{Case, Dynamics};

/// Told in a few words what a long search is working on.
pub type News = Arc<dyn Fn(&str) + Send + Sync>;

/// A declared model that answers a [`Case`]; cheap to clone.
#[derive(Clone)]
pub struct System {
    physics: Arc<dyn Physics>,
    tape: Option<Arc<Tape>>,
    news: Option<News>,
}

impl fmt::Debug for System {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.info().name)
    }
}

impl System {
    /// The model `M`; the number of its states is inferred: `System::of::<BeltOscillator, _>()`.
    #[must_use]
    pub fn of<M: Model<N>, const N: usize>() -> Self {
        Self {
            physics: Arc::new(Of::<M, N>::new()),
            tape: None,
            news: None,
        }
    }

    /// The same system, which says on what it is working while it looks for an orbit.
    #[must_use]
    pub fn telling(&self, news: News) -> Self {
        Self {
            news: Some(news),
            ..self.clone()
        }
    }

    /// Says on what it is working, if anybody listens.
    pub(super) fn tell(&self, words: impl FnOnce() -> String) {
        if let Some(news) = &self.news {
            news(&words());
        }
    }

    /// The same system, its passages kept on a tape: what is on the tape of the same question is not computed again.
    #[must_use]
    pub fn recorded(&self, tape: Arc<Tape>) -> Self {
        Self {
            tape: Some(tape),
            ..self.clone()
        }
    }

    /// The model as data.
    #[must_use]
    pub fn info(&self) -> &'static ModelInfo {
        self.physics.info()
    }

    /// Whether the case can be asked at all: at both ends of what is followed.
    ///
    /// # Errors
    /// A parameter is out of its bounds, a smoothing would falsify a law, or there is nothing to follow.
    pub fn check(&self, case: &Case) -> Result<(), StudyError> {
        if case.design() == Design::Smoothing && case.smoothing().is_none() {
            return Err(StudyError::NothingToSmooth);
        }
        let family = self.family(case);
        let (from, to) = case.along.map_or((0.0, 0.0), |along| along.span());
        family.at(from)?;
        family.at(to)?;
        Ok(())
    }

    /// Shows the law of each contact and each law with internal state, at the parameters and the start of the case.
    pub fn laws(&self, case: &Case, see: &mut dyn FnMut(Acting<'_>)) {
        self.physics.laws(case, &self.start(case), see);
    }

    /// Whether contacts act as declared, with modes.
    pub(super) fn touches(&self, case: &Case) -> bool {
        case.dynamics == Dynamics::Exact && self.info().touches()
    }

    /// The flows that the case is about, along its design variable.
    pub(super) fn family(&self, case: &Case) -> Family {
        let family = self.physics.family(case);
        match &self.tape {
            Some(tape) => family.recorded(tape),
            None => family,
        }
    }

    /// The flow where the case begins.
    pub(super) fn at(&self, case: &Case) -> Result<Box<dyn Flow>, FlowError> {
        self.family(case).at(self.beginning(case))
    }

    /// r, as the families count it, where the case begins.
    pub(super) fn beginning(&self, case: &Case) -> f64 {
        case.along.map_or(0.0, |along| along.span().0)
    }

    /// The state with which the case begins.
    pub(super) fn start(&self, case: &Case) -> Vec<f64> {
        let given = case.start.as_deref().unwrap_or_default();
        let states = self.info().states.iter().enumerate();
        states
            .map(|(j, state)| given.get(j).copied().unwrap_or(state.start))
            .collect()
    }

    /// The field of the case over boxes: sliding in these modes, or smooth.
    pub(super) fn enclosure(&self, case: &Case, modes: Option<&[Mode]>) -> Box<dyn Enclosure> {
        self.physics.enclosure(case, modes)
    }

    /// The fastest rate that a copy adds at a state: see [`Point::stiffness`](crate::study::trade::Point).
    pub(super) fn stiffness(&self, case: &Case, state: &[f64], copy: Smoothing) -> f64 {
        self.physics.stiffness(case, state, copy)
    }

    /// The errors of the copy with this smoothing, predicted from the exact orbit of the case.
    ///
    /// # Errors
    /// See [`PredictError`].
    pub fn predict(
        &self,
        case: &Case,
        orbit: &Orbit,
        smoothing: Smoothing,
    ) -> Result<Prediction, PredictError> {
        self.physics.predict(case, orbit, smoothing)
    }
}

//! A declared model as an entry: which family answers, and from where it is asked.

use std::marker::PhantomData;

use super::branch::BranchRecord;
use super::case::{Case, Dynamics};
use super::ends::{End, TradeRecord};
use super::entry::{Entry, StudyError};
use super::equilibrium::{EquilibriaRecord, EquilibriumRecord};
use super::orbit::{OrbitRecord, Sought};
use super::seed::{Seed, on_the_belt};
use super::trade::{Scope, TradeError, trade};
use super::trajectory::{ExactReadout, Trajectory, trajectory};
use crate::field::Design;
use crate::flow::{ExactFamily, Family, FlowError, SmoothFamily, word};
use crate::integrate::Tolerance;
use crate::model::{Model, ModelInfo};
use crate::scalar::Inline;
use crate::shooting::Search;

/// The model `M`, whose number of states nobody else needs to know.
pub(super) struct Declared<M, const N: usize>(PhantomData<fn() -> M>);

impl<M: Model<N>, const N: usize> Declared<M, N> {
    pub(super) const fn new() -> Self {
        Self(PhantomData)
    }

    pub(super) fn model(case: &Case) -> M {
        let default = M::default().values();
        M::from_values(Inline::from_fn(|i| {
            let given = case.parameters.get(i).copied();
            given.unwrap_or(default.as_ref()[i])
        }))
    }

    pub(super) fn exact(case: &Case) -> ExactFamily<M, N> {
        let design = match case.along.map(|along| along.design) {
            Some(Design::Parameter(index)) => Some(index),
            Some(Design::Smoothing | Design::None) | None => None,
        };
        ExactFamily {
            model: Self::model(case),
            design,
            tolerance: Tolerance::for_accuracy(case.accuracy),
            magnitude: [1.0; N],
        }
    }

    pub(super) fn smooth(case: &Case) -> SmoothFamily<M, N> {
        SmoothFamily {
            model: Self::model(case),
            smoothing: case.smoothing(),
            design: case.along.map_or(Design::None, |along| along.design),
            tolerance: Tolerance::for_accuracy(case.accuracy),
            magnitude: [1.0; N],
        }
    }

    /// r, as the families count it, where the case begins.
    pub(super) fn beginning(case: &Case) -> f64 {
        case.along.map_or(0.0, |along| along.span().0)
    }

    pub(super) fn start(case: &Case) -> [f64; N] {
        std::array::from_fn(|j| {
            let given = case.start.as_ref().and_then(|start| start.get(j).copied());
            given.unwrap_or(M::INFO.states[j].start)
        })
    }

    /// Where orbits are looked for, first places first.
    fn seeds(case: &Case) -> Vec<Seed<N>> {
        let start = Self::start(case);
        let declared = Seed::at(start);
        match (&case.start, case.period) {
            (Some(_), period) => return vec![Seed { start, period }],
            (None, Some(_)) => {
                let period = case.period;
                return vec![Seed { start, period }, declared];
            }
            (None, None) => {}
        }
        let mut seeds = match case.dynamics {
            Dynamics::Exact => on_the_belt(&Self::model(case), start),
            Dynamics::Smoothed(_) => Self::exact_orbit(case).map_or_else(Vec::new, |seed| {
                // A copy may be out of reach of Newton and yet settle from there.
                vec![seed, Seed::at(seed.start)]
            }),
            Dynamics::Smooth => Vec::new(),
        };
        seeds.push(declared);
        seeds
    }

    /// The orbit of the exact system as a seed for its smooth copies.
    fn exact_orbit(case: &Case) -> Option<Seed<N>> {
        let exact = Case {
            dynamics: Dynamics::Exact,
            along: None,
            ..case.clone()
        };
        let family = Self::exact(&exact);
        let orbit = Self::sought_exactly(&exact, &family).orbit(0.0).ok()?;
        Some(Seed {
            start: orbit.place.state,
            period: Some(orbit.period),
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

    fn sought_exactly<'a>(
        case: &'a Case,
        family: &'a ExactFamily<M, N>,
    ) -> Sought<'a, ExactFamily<M, N>, N> {
        Sought {
            family,
            case,
            seeds: Self::seeds(case),
            search: Self::search(case),
            spelling: |segments| Some(word::<M, N>(segments)),
        }
    }

    fn sought_smoothly<'a>(
        case: &'a Case,
        family: &'a SmoothFamily<M, N>,
    ) -> Sought<'a, SmoothFamily<M, N>, N> {
        Sought {
            family,
            case,
            seeds: Self::seeds(case),
            search: Self::search(case),
            spelling: |_| None,
        }
    }
}

/// Whether a family has a flow at both ends of a case.
fn both_ends<F: Family<N>, const N: usize>(family: &F, case: &Case) -> Result<(), FlowError> {
    let (from, to) = case.along.map_or((0.0, 0.0), |along| along.span());
    family.at(from)?;
    family.at(to)?;
    Ok(())
}

impl<M: Model<N>, const N: usize> Entry for Declared<M, N> {
    fn info(&self) -> &'static ModelInfo {
        M::INFO
    }

    fn check(&self, case: &Case) -> Result<(), StudyError> {
        let smoothing = case.along.map(|along| along.design) == Some(Design::Smoothing);
        if smoothing && case.smoothing().is_none() {
            return Err(StudyError::NothingToSmooth);
        }
        match case.dynamics {
            Dynamics::Exact => both_ends(&Self::exact(case), case)?,
            Dynamics::Smooth | Dynamics::Smoothed(_) => both_ends(&Self::smooth(case), case)?,
        }
        Ok(())
    }

    fn motion(&self, case: &Case, time: f64) -> Result<Trajectory, StudyError> {
        let (start, r) = (Self::start(case), Self::beginning(case));
        Ok(match case.dynamics {
            Dynamics::Exact => {
                let readout = ExactReadout::new(Self::model(case));
                trajectory(&Self::exact(case).at(r)?, &readout, start, time)?
            }
            Dynamics::Smooth | Dynamics::Smoothed(_) => {
                let flow = Self::smooth(case).at(r)?;
                trajectory(&flow, flow.field(), start, time)?
            }
        })
    }

    fn orbit(&self, case: &Case) -> Result<OrbitRecord, StudyError> {
        let r = Self::beginning(case);
        Ok(match case.dynamics {
            Dynamics::Exact => Self::sought_exactly(case, &Self::exact(case)).found(r)?,
            Dynamics::Smooth | Dynamics::Smoothed(_) => {
                Self::sought_smoothly(case, &Self::smooth(case)).found(r)?
            }
        })
    }

    fn equilibria(&self, case: &Case) -> Result<Vec<EquilibriumRecord>, StudyError> {
        self.check(case)?;
        Self::all_equilibria(case)
    }

    fn equilibria_along(
        &self,
        case: &Case,
        watch: &mut dyn FnMut(&EquilibriumRecord),
    ) -> Result<EquilibriaRecord, StudyError> {
        self.check(case)?;
        let along = case.along.ok_or(StudyError::NothingToFollow)?;
        Self::equilibria_along(case, along, watch)
    }

    fn branch(
        &self,
        case: &Case,
        watch: &mut dyn FnMut(&OrbitRecord),
    ) -> Result<BranchRecord, StudyError> {
        self.check(case)?;
        let along = case.along.ok_or(StudyError::NothingToFollow)?;
        Ok(match case.dynamics {
            Dynamics::Exact => {
                Self::sought_exactly(case, &Self::exact(case)).branch(along, watch)?
            }
            Dynamics::Smooth | Dynamics::Smoothed(_) => {
                Self::sought_smoothly(case, &Self::smooth(case)).branch(along, watch)?
            }
        })
    }

    fn trade(&self, case: &Case, scope: &Scope) -> Result<TradeRecord, StudyError> {
        let at = |case: Case| {
            let exact = Self::sought_exactly(&case, &Self::exact(&case)).orbit(0.0)?;
            let trade = trade(&Self::model(&case), &exact, scope)?;
            Ok(End {
                parameters: case.parameters.clone(),
                trade,
            })
        };
        if M::INFO.contacts.is_empty() {
            return Err(TradeError::NoFriction {
                model: M::INFO.command,
            }
            .into());
        }
        TradeRecord::gather(case, at)
    }
}

//! A declared model as an entry: which family answers, and from where it is asked.

use std::marker::PhantomData;
use std::ops::ControlFlow;

use super::atlas::Hopf;
use super::branch::BranchRecord;
use super::case::{Along, Beginning, Case, Dynamics};
use super::characteristic::{Characteristic, Laws};
use super::curve::{CurveFinding, CurveRecord, CurveScope};
use super::diagram::{Diagram, DiagramRecord, Known, Watcher};
use super::ends::{End, TradeRecord};
use super::entry::{Entry, StudyError};
use super::equilibrium::{EquilibriaRecord, EquilibriumRecord};
use super::modes::sliding_modes;
use super::orbit::{CertifiedOrbit, OrbitRecord, Sought};
use super::section::{CrossingRecord, Span};
use super::seed::{Seed, on_the_belt};
use super::trade::{Finding, Scope, TradeError, tradable, watched};
use super::trajectory::{ExactReadout, Trajectory, trajectory};
use crate::equilibrium::{Proof, Unproven, find};
use crate::field::Design;
use crate::flow::{ExactFamily, Family, FlowError, SmoothFamily, Tape, Taped, word};
use crate::integrate::Tolerance;
use crate::model::{Model, ModelInfo};
use crate::poincare::Section;
use crate::scalar::Inline;
use crate::shooting::{OrbitError, Search};

/// A motion that has settled is this near to its equilibrium.
const SETTLED: f64 = 1e-3;

/// The model `M`, whose number of states nobody else needs to know.
pub(super) struct Declared<M, const N: usize>(PhantomData<fn() -> M>);

impl<M: Model<N>, const N: usize> Declared<M, N> {
    /// Whether there is friction to be exact about. What only such a model needs is not compiled for the others: that is
    /// half of all, wherever this is asked as a constant.
    pub(super) const RUBS: bool = !M::INFO.contacts.is_empty();

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
    fn seeds(case: &Case, tape: &Tape<'_>) -> Vec<Seed<N>> {
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
            Dynamics::Exact if const { Self::RUBS } => on_the_belt(&Self::model(case), start),
            Dynamics::Smoothed(_) if const { Self::RUBS } => {
                Self::exact_orbit(case, tape).map_or_else(Vec::new, |seed| {
                    // A copy may be out of reach of Newton and yet settle from there.
                    vec![seed, Seed::at(seed.start)]
                })
            }
            _ => Vec::new(),
        };
        seeds.push(declared);
        seeds
    }

    /// The orbit of the exact system as a seed for its smooth copies.
    fn exact_orbit(case: &Case, tape: &Tape<'_>) -> Option<Seed<N>> {
        let exact = Case {
            dynamics: Dynamics::Exact,
            along: None,
            ..case.clone()
        };
        let family = tape.record(Self::exact(&exact));
        let orbit = Self::sought_exactly(&exact, &family).orbit(0.0).ok()?;
        Some(Seed {
            start: orbit.place.state,
            period: Some(orbit.period),
        })
    }

    /// A model with a drive has no equilibrium, and one whose laws have stops has none that stands alone.
    fn may_rest() -> Result<(), StudyError> {
        let stopping = M::INFO
            .memories
            .iter()
            .find(|memory| memory.law.has_stops());
        if let Some(memory) = stopping {
            return Err(StudyError::NotIsolated {
                model: M::INFO.command,
                law: memory.law.name,
            });
        }
        match M::INFO.drive {
            None => Ok(()),
            Some(phase) => Err(StudyError::Driven {
                model: M::INFO.command,
                phase: M::INFO.states[phase].name,
            }),
        }
    }

    /// An error that names an equilibrium, with its exact place where Newton finds it.
    fn sharpened(case: &Case, error: OrbitError) -> OrbitError {
        let OrbitError::Equilibrium { state } = &error else {
            return error;
        };
        let near: [f64; N] = std::array::from_fn(|j| state.get(j).copied().unwrap_or(0.0));
        let r = Self::beginning(case);
        let places: Vec<[f64; N]> = match case.dynamics {
            Dynamics::Exact if const { Self::RUBS } => {
                let model = Self::model(case);
                let found = find(&Self::exact(case), r, &[near], |y| sliding_modes(&model, y));
                found.iter().map(|one| one.place.state).collect()
            }
            _ => {
                let found = find(&Self::smooth(case), r, &[near], |_| vec![()]);
                found.iter().map(|one| one.place.state).collect()
            }
        };
        let size = near.iter().fold(1.0_f64, |size, y| size.max(y.abs()));
        let close = |place: &&[f64; N]| {
            let off = place.iter().zip(&near).map(|(a, b)| (a - b).abs());
            off.fold(0.0, f64::max) <= SETTLED * size
        };
        match places.iter().find(close) {
            Some(place) => OrbitError::Equilibrium {
                state: place.to_vec(),
            },
            None => error,
        }
    }

    /// The Hopf point at which the branch of a case begins, if it begins at one.
    fn hopf(case: &Case, along: Along) -> Result<Option<Hopf<N>>, StudyError> {
        if case.beginning != Beginning::Hopf {
            return Ok(None);
        }
        let branch = Self::equilibria_along(case, along, &mut |_| ControlFlow::Continue(()))?;
        let point = branch.special.iter().find_map(|point| {
            let period = point.period?;
            let r = Along {
                from: point.r,
                ..along
            };
            let state = point.state.as_slice().try_into().ok()?;
            Some(Hopf {
                r: r.span().0,
                state,
                period,
            })
        });
        point.map(Some).ok_or(StudyError::NoHopf)
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
        family: &'a Taped<'a, ExactFamily<M, N>>,
    ) -> Sought<'a, Taped<'a, ExactFamily<M, N>>, N> {
        Sought {
            family,
            case,
            seeds: Self::seeds(case, family.tape()),
            search: Self::search(case),
            spelling: |segments| Some(word::<M, N>(segments)),
        }
    }

    fn sought_smoothly<'a>(
        case: &'a Case,
        family: &'a Taped<'a, SmoothFamily<M, N>>,
    ) -> Sought<'a, Taped<'a, SmoothFamily<M, N>>, N> {
        Sought {
            family,
            case,
            seeds: Self::seeds(case, family.tape()),
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

    fn laws(&self, case: &Case, see: &mut dyn FnMut(usize, &dyn Characteristic)) {
        let _ = M::rhs(
            &Self::model(case).values(),
            Self::start(case),
            &mut Laws(see),
        );
    }

    fn check(&self, case: &Case) -> Result<(), StudyError> {
        let smoothing = case.along.map(|along| along.design) == Some(Design::Smoothing);
        if smoothing && case.smoothing().is_none() {
            return Err(StudyError::NothingToSmooth);
        }
        match case.dynamics {
            Dynamics::Exact if const { Self::RUBS } => both_ends(&Self::exact(case), case)?,
            _ => both_ends(&Self::smooth(case), case)?,
        }
        Ok(())
    }

    fn motion(&self, case: &Case, time: f64) -> Result<Trajectory, StudyError> {
        let (start, r) = (Self::start(case), Self::beginning(case));
        Ok(match case.dynamics {
            Dynamics::Exact if const { Self::RUBS } => {
                let readout = ExactReadout::new(Self::model(case));
                trajectory(&Self::exact(case).at(r)?, &readout, start, time)?
            }
            _ => {
                let flow = Self::smooth(case).at(r)?;
                trajectory(&flow, flow.field(), start, time)?
            }
        })
    }

    fn crossings(
        &self,
        case: &Case,
        section: Section,
        span: Span,
    ) -> Result<Vec<CrossingRecord>, StudyError> {
        let (start, r) = (Self::start(case), Self::beginning(case));
        Ok(match case.dynamics {
            Dynamics::Exact if const { Self::RUBS } => {
                span.crossings(&Self::exact(case).at(r)?, start, section)?
            }
            _ => span.crossings(&Self::smooth(case).at(r)?, start, section)?,
        })
    }

    fn orbit(&self, case: &Case) -> Result<OrbitRecord, StudyError> {
        let (r, tape) = (Self::beginning(case), Tape::blank());
        let found = match case.dynamics {
            Dynamics::Exact if const { Self::RUBS } => {
                Self::sought_exactly(case, &tape.record(Self::exact(case))).found(r)
            }
            _ => Self::sought_smoothly(case, &tape.record(Self::smooth(case))).found(r),
        };
        Ok(found.map_err(|error| Self::sharpened(case, error))?)
    }

    fn certified_orbit(&self, case: &Case) -> Result<CertifiedOrbit, StudyError> {
        let (r, tape) = (Self::beginning(case), Tape::blank());
        let found = match case.dynamics {
            Dynamics::Exact if const { Self::RUBS } => {
                Self::sought_exactly(case, &tape.record(Self::exact(case))).certified(r)
            }
            _ => Self::sought_smoothly(case, &tape.record(Self::smooth(case))).certified(r),
        };
        Ok(found.map_err(|error| Self::sharpened(case, error))?)
    }

    fn equilibria(&self, case: &Case) -> Result<Vec<EquilibriumRecord>, StudyError> {
        self.check(case)?;
        Self::may_rest()?;
        Self::all_equilibria(case)
    }

    fn proofs(&self, case: &Case, found: &[EquilibriumRecord]) -> Vec<Result<Proof, Unproven>> {
        found.iter().map(|one| Self::proof(case, one)).collect()
    }

    fn equilibria_along(
        &self,
        case: &Case,
        watch: &mut dyn FnMut(&EquilibriumRecord) -> ControlFlow<()>,
    ) -> Result<EquilibriaRecord, StudyError> {
        self.check(case)?;
        Self::may_rest()?;
        let along = case.along.ok_or(StudyError::NothingToFollow)?;
        Self::equilibria_along(case, along, watch)
    }

    fn branch(
        &self,
        case: &Case,
        tape: &Tape<'_>,
        watch: &mut dyn FnMut(&OrbitRecord) -> ControlFlow<()>,
    ) -> Result<BranchRecord, StudyError> {
        self.check(case)?;
        let along = case.along.ok_or(StudyError::NothingToFollow)?;
        let hopf = Self::hopf(case, along)?;
        match case.dynamics {
            Dynamics::Exact if const { Self::RUBS } => {
                Self::sought_exactly(case, &tape.record(Self::exact(case)))
                    .branch(along, hopf, watch)
            }
            _ => Self::sought_smoothly(case, &tape.record(Self::smooth(case)))
                .branch(along, hopf, watch),
        }
    }

    fn curve(
        &self,
        case: &Case,
        scope: &CurveScope,
        tape: &Tape<'_>,
        watch: &mut dyn FnMut(CurveFinding<'_>) -> ControlFlow<()>,
    ) -> Result<CurveRecord, StudyError> {
        self.check(case)?;
        let along = case.along.ok_or(StudyError::NothingToFollow)?;
        for value in [scope.and.from, scope.and.to] {
            let other = Case {
                along: Some(scope.and),
                ..case.clone()
            };
            self.check(&other.at(value))?;
        }
        match case.dynamics {
            Dynamics::Exact if const { Self::RUBS } => {
                Self::sought_exactly(case, &tape.record(Self::exact(case)))
                    .curve(along, scope, watch)
            }
            _ => Self::sought_smoothly(case, &tape.record(Self::smooth(case)))
                .curve(along, scope, watch),
        }
    }

    fn diagram(
        &self,
        case: &Case,
        diagram: &Diagram,
        known: &Known,
        watch: Watcher<'_>,
    ) -> Result<DiagramRecord, StudyError> {
        self.check(case)?;
        let along = case.along.ok_or(StudyError::NothingToFollow)?;
        let start = Self::start(case);
        Ok(match case.dynamics {
            Dynamics::Exact if const { Self::RUBS } => {
                diagram.draw(&Self::exact(case), along, start, known, watch)
            }
            _ => diagram.draw(&Self::smooth(case), along, start, known, watch),
        })
    }

    fn trade(
        &self,
        case: &Case,
        scope: &Scope,
        watch: &mut dyn FnMut(usize, Finding<'_>) -> ControlFlow<()>,
    ) -> Result<TradeRecord, StudyError> {
        tradable(M::INFO)?;
        if const { Self::RUBS } {
            TradeRecord::gather(case, |case: Case, end: usize| {
                let tape = Tape::blank();
                let family = tape.record(Self::exact(&case));
                let exact = Self::sought_exactly(&case, &family).orbit(0.0)?;
                let mut here = |finding: Finding<'_>| watch(end, finding);
                let trade = watched(&Self::model(&case), &exact, scope, &mut here)?;
                Ok(End {
                    parameters: case.parameters.clone(),
                    trade,
                })
            })
        } else {
            let model = M::INFO.command;
            Err(TradeError::NoFriction { model }.into())
        }
    }
}

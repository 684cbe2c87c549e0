//! What the report asks of the systems, as any program would, and what the answers cost.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use stickslip::field::{Design, Work};
use stickslip::flow::Tape;
use stickslip::model::{Model, ModelInfo, ParamId};
use stickslip::study::trade::{Finding, Scope, Trade};
use stickslip::study::{
    Along, BranchRecord, Case, Dynamics, Entry, EquilibriaRecord, OrbitRecord, StudyError,
    Trajectory, entry,
};

use super::ReproduceError;

/// Relative accuracy of the orbits of the report.
const ACCURACY: f64 = 1e-8;
/// Time after which a motion has settled.
const SETTLED: f64 = 1000.0;
/// A branch that has turned back by this share of its way has passed a fold.
const TURNED: f64 = 1e-3;

/// A declared system, and its parameter that is varied.
pub(super) struct Subject {
    entry: Box<dyn Entry>,
    parameter: usize,
}

/// A periodic orbit with one period of its motion.
pub(super) struct Cycle {
    pub(super) orbit: OrbitRecord,
    pub(super) path: Vec<Vec<f64>>,
    pub(super) time: Duration,
}

/// A branch as far as its first fold, and what it cost.
pub(super) struct Branch {
    pub(super) along: Along,
    pub(super) points: Vec<OrbitRecord>,
    pub(super) end: End,
    pub(super) time: Duration,
    pub(super) work: Work,
}

/// Where a branch ends, and why.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct End {
    pub(super) r: f64,
    pub(super) why: Why,
}

/// Why a branch ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Why {
    /// It was told to.
    Reached,
    /// The cycle has shrunk to an equilibrium.
    Vanishes,
    /// The cycle meets an unstable one and turns back with it.
    Folds,
    /// The motion comes to rest for an instant only.
    Grazes,
    /// Path following gave up.
    GaveUp,
}

impl Subject {
    /// The system to which a parameter belongs.
    pub(super) fn new<M: Model<N>, const N: usize>(parameter: ParamId<M>) -> Self {
        Self {
            entry: entry::<M, N>(),
            parameter: parameter.index,
        }
    }

    /// The model as data.
    pub(super) fn info(&self) -> &'static ModelInfo {
        self.entry.info()
    }

    /// The system as declared but for the parameter that is varied.
    pub(super) fn case(&self, dynamics: Dynamics, r: f64) -> Case {
        let mut case = Case::declared(self.info(), dynamics);
        case.parameters[self.parameter] = r;
        case.accuracy = ACCURACY;
        case
    }

    /// The orbit of a case that may be out of bounds.
    pub(super) fn orbit(&self, case: &Case) -> Result<OrbitRecord, StudyError> {
        self.entry.check(case)?;
        self.entry.orbit(case)
    }

    /// The orbit where the parameter is r.
    pub(super) fn cycle(&self, dynamics: Dynamics, r: f64) -> Result<Cycle, ReproduceError> {
        let case = self.case(dynamics, r);
        self.drawn(&case).map_err(self.missing(&case))
    }

    /// The orbit where the parameter is r to which the motion from `start` settles.
    pub(super) fn settled(
        &self,
        dynamics: Dynamics,
        r: f64,
        start: &[f64],
    ) -> Result<Cycle, ReproduceError> {
        let mut case = self.case(dynamics, r);
        case.start = Some(start.to_vec());
        let clock = Instant::now();
        let motion = self.entry.motion(&case, SETTLED);
        case.start = motion.map_err(self.missing(&case))?.states.pop();
        let cycle = self.drawn(&case).map_err(self.missing(&case))?;
        let time = clock.elapsed();
        Ok(Cycle { time, ..cycle })
    }

    fn drawn(&self, case: &Case) -> Result<Cycle, StudyError> {
        let clock = Instant::now();
        let orbit = self.entry.orbit(case)?;
        let time = clock.elapsed();
        let path = self.motion(&orbit, ACCURACY)?.states;
        Ok(Cycle { orbit, path, time })
    }

    /// One period of an orbit.
    pub(super) fn motion(
        &self,
        orbit: &OrbitRecord,
        accuracy: f64,
    ) -> Result<Trajectory, StudyError> {
        let case = Case {
            accuracy,
            ..self.from(orbit)
        };
        self.entry.motion(&case, orbit.period)
    }

    /// The branch from `orbit` until the parameter is `to`, or as far as it goes.
    pub(super) fn branch(&self, orbit: &OrbitRecord, to: f64) -> Result<Branch, ReproduceError> {
        let mut case = self.from(orbit);
        let along = self.along(orbit.parameters[self.parameter], to);
        case.along = Some(along);
        let clock = Instant::now();
        let mut farthest = 0.0_f64;
        let mut watch = |point: &OrbitRecord| {
            let share = (at(point) - along.from) / (along.to - along.from);
            farthest = farthest.max(share);
            if share < farthest - TURNED {
                return ControlFlow::Break(());
            }
            ControlFlow::Continue(())
        };
        let record = self.entry.branch(&case, &Tape::blank(), &mut watch);
        let record = record.map_err(self.missing(&case))?;
        Ok(Branch::of(record, clock.elapsed()))
    }

    /// The branch of a case with all that leave it.
    pub(super) fn branches(&self, case: &Case) -> Result<BranchRecord, ReproduceError> {
        let mut watch = |_: &OrbitRecord| ControlFlow::Continue(());
        let record = self.entry.branch(case, &Tape::blank(), &mut watch);
        record.map_err(self.missing(case))
    }

    /// The branch of equilibria between two values of the parameter.
    pub(super) fn equilibria(
        &self,
        dynamics: Dynamics,
        [from, to]: [f64; 2],
    ) -> Result<EquilibriaRecord, ReproduceError> {
        let mut case = self.case(dynamics, from);
        case.along = Some(self.along(from, to));
        let mut watch = |_: &_| ControlFlow::Continue(());
        let record = self.entry.equilibria_along(&case, &mut watch);
        record.map_err(self.missing(&case))
    }

    /// Error against cost of the copies where the parameter is r.
    pub(super) fn trade(&self, r: f64, scope: &Scope) -> Result<Vec<Trade>, ReproduceError> {
        let case = self.case(Dynamics::Exact, r);
        let mut watch = |_, _: Finding<'_>| ControlFlow::Continue(());
        let record = self.entry.trade(&case, scope, &mut watch);
        let ends = record.map_err(self.missing(&case))?.ends.into_iter();
        Ok(ends.map(|end| end.trade).collect())
    }

    /// The friction force at a relative speed, positive where the speed is.
    pub(super) fn force(&self, dynamics: Dynamics, speed: f64) -> f64 {
        let case = Case::declared(self.info(), dynamics);
        let mut force = f64::NAN;
        self.entry.laws(&case, &mut |_, law| {
            force = match dynamics {
                Dynamics::Smoothed(smoothing) => law.copied(smoothing, speed),
                Dynamics::Smooth | Dynamics::Exact => law.sliding(speed.abs()).copysign(speed),
            };
        });
        force
    }

    /// The parameter that is varied, followed.
    pub(super) fn along(&self, from: f64, to: f64) -> Along {
        let design = Design::Parameter(self.parameter);
        Along { design, from, to }
    }

    /// The case whose orbit is known.
    fn from(&self, orbit: &OrbitRecord) -> Case {
        Case {
            parameters: orbit.parameters.clone(),
            start: Some(orbit.state.clone()),
            period: Some(orbit.period),
            accuracy: ACCURACY,
            ..Case::declared(self.info(), orbit.dynamics)
        }
    }

    fn missing(&self, case: &Case) -> impl FnOnce(StudyError) -> ReproduceError {
        let info = self.info();
        let (parameter, r) = (self.parameter, case.parameters[self.parameter]);
        let name = info.parameters[parameter].name;
        let what = format!("{}, {}, {name} = {r}", info.command, case.dynamics);
        |source| ReproduceError::Missing { what, source }
    }
}

impl Branch {
    fn of(record: BranchRecord, time: Duration) -> Self {
        let fold = record.special.iter().find(|point| point.kind == "fold");
        let special = record.special.last().map_or(f64::NAN, |point| point.r);
        let last = record.points.last().map_or(f64::NAN, at);
        let (r, why) = match (fold, record.ended.word) {
            (Some(fold), _) => (fold.r, Why::Folds),
            (None, "reached-end") => (last, Why::Reached),
            (None, "equilibrium") => (last, Why::Vanishes),
            (None, "grazing-sliding") => (special, Why::Grazes),
            (None, _) => (last, Why::GaveUp),
        };
        let work = work(&record.points);
        let count = fold.map_or(record.points.len(), |fold| fold.after);
        let mut points = record.points;
        points.truncate(count);
        Self {
            along: record.along,
            points,
            end: End { r, why },
            time,
            work,
        }
    }
}

/// The parameter of an orbit on a branch.
pub(super) fn at(orbit: &OrbitRecord) -> f64 {
    orbit.r.unwrap_or(f64::NAN)
}

/// What these orbits cost.
pub(super) fn work<'a>(points: impl IntoIterator<Item = &'a OrbitRecord>) -> Work {
    let mut work = Work::default();
    points.into_iter().for_each(|point| work += point.work);
    work
}

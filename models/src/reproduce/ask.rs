//! What the report asks of the systems, as any program would, and what the answers cost.

use std::ops::ControlFlow;
use std::time::Instant;

use stickslip::field::Design;
use stickslip::model::{Model, ModelInfo, ParamId};
use stickslip::study::trade::{Scope, Trade};
use stickslip::study::{
    Acting, Along, BranchRecord, Case, Dynamics, EquilibriaRecord, OrbitRecord, StudyError, System,
    Trajectory,
};

use super::ReproduceError;
use super::branch::{Branch, at};

/// Relative accuracy of the orbits of the report.
const ACCURACY: f64 = 1e-8;
/// Time after which a motion has settled.
const SETTLED: f64 = 1000.0;
/// A branch that has turned back by this share of its way has passed a fold.
const TURNED: f64 = 1e-3;

/// A declared system, and its parameter that is varied.
pub(super) struct Subject {
    entry: System,
    parameter: usize,
}

/// A periodic orbit with one period of its motion.
pub(super) struct Cycle {
    pub(super) orbit: OrbitRecord,
    pub(super) motion: Trajectory,
}

impl Subject {
    /// The system to which a parameter belongs.
    pub(super) fn new<M: Model<N>, const N: usize>(parameter: ParamId<M>) -> Self {
        Self {
            entry: System::of::<M, N>(),
            parameter: parameter.index,
        }
    }

    /// The model as data.
    pub(super) fn info(&self) -> &'static ModelInfo {
        self.entry.info()
    }

    /// The name of the parameter that is varied.
    pub(super) fn name(&self) -> &'static str {
        self.info().parameters[self.parameter].name
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
        self.drawn(&self.case(dynamics, r))
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
        let motion = self.entry.motion(&case, SETTLED);
        case.start = motion.map_err(self.missing(&case))?.states.pop();
        self.drawn(&case)
    }

    fn drawn(&self, case: &Case) -> Result<Cycle, ReproduceError> {
        let orbit = self.entry.orbit(case).map_err(self.missing(case))?;
        let motion = self.motion(&orbit, ACCURACY);
        let motion = motion.map_err(self.missing(case))?;
        Ok(Cycle { orbit, motion })
    }

    /// One period of an orbit.
    pub(super) fn motion(
        &self,
        orbit: &OrbitRecord,
        accuracy: f64,
    ) -> Result<Trajectory, StudyError> {
        let case = Case {
            parameters: orbit.parameters.clone(),
            start: Some(orbit.state.clone()),
            accuracy,
            ..Case::declared(self.info(), orbit.dynamics)
        };
        self.entry.motion(&case, orbit.period)
    }

    /// The branch between two values of the parameter, or as far as it goes.
    pub(super) fn branch(
        &self,
        dynamics: Dynamics,
        from: f64,
        to: f64,
    ) -> Result<Branch, ReproduceError> {
        let mut case = self.case(dynamics, from);
        case.along = Some(self.along(from, to));
        let clock = Instant::now();
        let mut farthest = 0.0_f64;
        let mut watch = |point: &OrbitRecord| {
            let share = (at(point) - from) / (to - from);
            farthest = farthest.max(share);
            match share < farthest - TURNED {
                true => ControlFlow::Break(()),
                false => ControlFlow::Continue(()),
            }
        };
        let record = self.entry.branch_watched(&case, &mut watch);
        let record = record.map_err(self.missing(&case))?;
        Ok(Branch::of(record, clock.elapsed()))
    }

    /// The branch of a case with all that leave it.
    pub(super) fn branches(&self, case: &Case) -> Result<BranchRecord, ReproduceError> {
        self.entry.branch(case).map_err(self.missing(case))
    }

    /// The branch of equilibria between two values of the parameter.
    pub(super) fn equilibria(
        &self,
        dynamics: Dynamics,
        [from, to]: [f64; 2],
    ) -> Result<EquilibriaRecord, ReproduceError> {
        let mut case = self.case(dynamics, from);
        case.along = Some(self.along(from, to));
        let record = self.entry.equilibria_along(&case);
        record.map_err(self.missing(&case))
    }

    /// Error against cost of the copies where the parameter is r.
    pub(super) fn trade(&self, r: f64, scope: &Scope) -> Result<Vec<Trade>, ReproduceError> {
        let case = self.case(Dynamics::Exact, r);
        let record = self.entry.trade(&case, scope);
        let ends = record.map_err(self.missing(&case))?.ends.into_iter();
        Ok(ends.map(|end| end.trade).collect())
    }

    /// The friction force at a relative speed, positive where the speed is.
    pub(super) fn force(&self, dynamics: Dynamics, speed: f64) -> f64 {
        let case = Case::declared(self.info(), dynamics);
        let mut force = f64::NAN;
        self.entry.laws(&case, &mut |law| {
            let Acting::Static(_, law) = law else { return };
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

    fn missing(&self, case: &Case) -> impl FnOnce(StudyError) -> ReproduceError {
        let (system, dynamics, name) = (self.info().command, case.dynamics, self.name());
        let r = case.parameters[self.parameter];
        let what = format!("{system}, {dynamics}, {name} = {r}");
        |error| ReproduceError::Missing {
            what,
            source: Box::new(error),
        }
    }
}

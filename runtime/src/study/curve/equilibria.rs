//! A fold or Hopf point of equilibria followed in two design variables.

use super::choice::{choose, not_followed};
use super::found::Watch;
use super::reader::Reader;
use super::record::{CurveFinding, CurvePointRecord, CurveScope, Curved};
use crate::continuation::Kind;
use crate::curve::{Condition, CriticalEquilibrium, CurvePoint, Plane, follow_equilibrium};
use crate::equilibrium::settings;
use crate::motion::Place;
use crate::study::equilibria::EquilibriaRecord;
use crate::study::error::StudyError;
use crate::study::question::{Along, Case};
use crate::study::system::System;

impl System {
    /// A fold or a Hopf point of the branch of equilibria along the design variable of the case, followed in that variable
    /// and another one; `watch` sees each equilibrium of the branch and each point of the curve as it is found, and may end
    /// either there.
    ///
    /// # Errors
    /// There is no equilibrium to begin with, or no such point on its branch, or no such point can be followed.
    pub fn equilibria_curve_watched(
        &self,
        case: &Case,
        scope: &CurveScope,
        watch: Watch<'_>,
    ) -> Result<Curved<EquilibriaRecord>, StudyError> {
        let along = self.checked(case, scope)?;
        let mut seen = |point: &_| watch(CurveFinding::Equilibrium(point));
        let (branch, modes) = self.equilibria_stem(case, &mut seen)?;
        if branch.ended.is_interrupted() {
            return Ok(Curved::Interrupted(Box::new(branch)));
        }
        let all = branch.special.iter();
        let all: Vec<(String, Kind)> = all.map(|one| (one.label.clone(), one.kind)).collect();
        let known = |kind| Condition::of_equilibria(kind).is_some();
        let place = choose(&all, scope.of.as_deref(), ("fold or Hopf", known))?;
        let (of, from) = (all[place].clone(), &branch.special[place]);
        let plane = Plane {
            family: self.family(case),
            designs: [along.design, scope.and.design],
        };
        let (and_from, and_to) = scope.and.span();
        let (window_from, window_to) = along.span();
        let read = Reader {
            along,
            and: scope.and,
        };
        let mut seen = |point: &CurvePoint<CriticalEquilibrium>| {
            let record: CurvePointRecord = read.equilibrium(point);
            watch(CurveFinding::Point(&record))
        };
        let at = Along {
            from: from.r,
            ..along
        };
        let begun = Place {
            state: from.state.clone(),
            modes,
        };
        let found = follow_equilibrium(
            &plane,
            of.1,
            (&begun, at.span().0),
            [window_from, window_to],
            settings(and_from, and_to),
            &mut seen,
        );
        let found = found.map_err(StudyError::Curve)?;
        let found = found.ok_or_else(|| not_followed(&of.0, of.1))?;
        let found = read.curve(found, Reader::equilibrium, |point| point.still);
        Ok(Curved::Followed(Box::new(read.record(branch, of, found))))
    }
}

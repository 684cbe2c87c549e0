//! A bifurcation followed in two design variables, and all that is reported of it.

use std::ops::ControlFlow;

use super::choice::{choose, not_followed};
use super::reader::Reader;
use super::record::{CurveFinding, CurvePointRecord, CurveScope, Curved};
use crate::continuation::{Kind, Settings};
use crate::curve::{BorderPoint, Condition, CurvePoint, Plane, follow, follow_border};
use crate::integrate::Tolerance;
use crate::shooting::Orbit;
use crate::study::branch::{BranchRecord, Hopf, numbered};
use crate::study::error::StudyError;
use crate::study::orbit::Sought;
use crate::study::question::{Along, Case};
use crate::study::system::System;

/// Tolerance of a curve, as a share of the accuracy of its points: multipliers lose digits that orbits keep.
const SHARPER: f64 = 0.02;

/// Told of each finding; a break ends the branch or the curve there.
pub(in crate::study) type Watch<'a> = &'a mut dyn FnMut(CurveFinding<'_>) -> ControlFlow<()>;

impl System {
    /// A special point of the branch along the design variable of the case, followed in that variable and another one;
    /// `watch` sees each orbit of the branch and each point of the curve as it is found, and may end either there.
    ///
    /// # Errors
    /// There is no orbit to begin with, or no such point on its branch, or no such point can be followed.
    pub fn curve_watched(
        &self,
        case: &Case,
        scope: &CurveScope,
        watch: Watch<'_>,
    ) -> Result<Curved, StudyError> {
        let along = self.checked(case, scope)?;
        let hopf = self.hopf(case, along)?;
        self.sought(case)?.curve((along, hopf), scope, watch)
    }

    /// What is followed first, if the case can be asked at both ends of what is followed besides.
    pub(super) fn checked(&self, case: &Case, scope: &CurveScope) -> Result<Along, StudyError> {
        self.check(case)?;
        for value in [scope.and.from, scope.and.to] {
            let other = Case {
                along: Some(scope.and),
                ..case.clone()
            };
            self.check(&other.at(value))?;
        }
        case.along.ok_or(StudyError::NothingToFollow)
    }
}

impl Sought<'_> {
    /// Follows the branch along `along` to the special point asked for, and that point in both variables.
    fn curve(
        &self,
        (along, hopf): (Along, Option<Hopf>),
        scope: &CurveScope,
        watch: Watch<'_>,
    ) -> Result<Curved, StudyError> {
        let (from, to) = along.span();
        let accuracy = self.search.accuracy;
        let stretch = self.stem(along, hopf, &mut |orbit| watch(CurveFinding::Orbit(orbit)))?;
        let located = stretch.located;
        let branch = BranchRecord {
            along,
            from: None,
            root: None,
            points: stretch.points,
            special: numbered(&along, &located),
            ended: stretch.ended,
            began: stretch.began,
            branches: Vec::new(),
        };
        if branch.is_interrupted() {
            return Ok(Curved::Interrupted(Box::new(branch)));
        }
        let labels = branch.special.iter().map(|special| special.label.clone());
        let all: Vec<(String, Kind)> = labels.zip(located.iter().map(|one| one.kind)).collect();
        let known = |kind: Kind| kind.is_border() || Condition::of_orbits(kind).is_some();
        let known = ("fold, flip, torus, grazing or sliding", known);
        let place = choose(&all, scope.of.as_deref(), known)?;
        let (label, kind) = (&all[place].0, all[place].1);
        let (and_from, and_to) = scope.and.span();
        let plane = Plane {
            family: self
                .family
                .with_tolerance(Tolerance::for_accuracy(SHARPER * accuracy)),
            designs: [along.design, scope.and.design],
        };
        let settings = Settings {
            largest_step: 0.1,
            ..Settings::new(and_from, and_to, accuracy)
        };
        let read = Reader {
            along,
            and: scope.and,
        };
        let (located, window) = (&located[place], [from, to]);
        let mut see = |point: &CurvePointRecord| watch(CurveFinding::Point(point));
        let curve = if kind.is_border() {
            let mut seen = |point: &BorderPoint| see(&read.border(point));
            let (orbit, r) = ((kind, &located.point), located.r);
            let found = follow_border(&plane, orbit, r, window, settings, &mut seen);
            found.map(|found| found.map(|found| read.curve(found, Reader::border, |_| None)))
        } else {
            let mut seen = |point: &CurvePoint<Orbit>| see(&read.orbit(point));
            let found = follow(&plane, kind, &located.point, window, settings, &mut seen);
            found.map(|found| found.map(|found| read.curve(found, Reader::orbit, |at| at.still)))
        };
        let curve = curve.map_err(StudyError::Curve)?;
        let found = curve.ok_or_else(|| not_followed(label, kind))?;
        let record = read.record(branch, (label.clone(), kind), found);
        Ok(Curved::Followed(Box::new(record)))
    }
}

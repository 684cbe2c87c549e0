//! A bifurcation followed in two design variables, and all that is reported of it.

use std::ops::ControlFlow;

use super::record::{
    CurveFinding, CurvePointRecord, CurveRecord, CurveScope, Curved, SpecialCurvePoint,
};
use crate::continuation::{Kind, Settings};
use crate::curve::{self, CurvePoint, GrazingPoint, Plane, follow, follow_graze};
use crate::field::Work;
use crate::integrate::Tolerance;
use crate::study::branch::{BranchRecord, Hopf, numbered};
use crate::study::ended::Ended;
use crate::study::error::StudyError;
use crate::study::label::labels;
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
        self.check(case)?;
        let along = case.along.ok_or(StudyError::NothingToFollow)?;
        for value in [scope.and.from, scope.and.to] {
            let other = Case {
                along: Some(scope.and),
                ..case.clone()
            };
            self.check(&other.at(value))?;
        }
        let hopf = self.hopf(case, along)?;
        self.sought(case)?.curve((along, hopf), scope, watch)
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
        let place = choose(&all, scope.of.as_deref())?;
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
        let curve = if kind == Kind::GrazingSliding {
            let mut seen = |point: &GrazingPoint| see(&read.graze(point));
            let (orbit, r) = (&located.point, located.r);
            let found = follow_graze(&plane, orbit, r, window, settings, &mut seen);
            found.map(|found| found.map(|found| read.curve(found, Reader::graze, |_| None)))
        } else {
            let mut seen = |point: &CurvePoint| see(&read.point(point));
            let found = follow(&plane, kind, &located.point, window, settings, &mut seen);
            found.map(|found| found.map(|found| read.curve(found, Reader::point, |at| at.still)))
        };
        let curve = curve.map_err(StudyError::Curve)?;
        let (points, special, ended, work) = curve.ok_or_else(|| not_followed(label, kind))?;
        Ok(Curved::Followed(Box::new(CurveRecord {
            branch,
            along,
            and: scope.and,
            of: label.clone(),
            kind,
            points,
            special,
            ended,
            work,
        })))
    }
}

/// The number of the special point that is asked for.
fn choose(all: &[(String, Kind)], wanted: Option<&str>) -> Result<usize, StudyError> {
    let known = |kind: Kind| kind == Kind::GrazingSliding || curve::Condition::of(kind).is_some();
    let found = all.iter().position(|(label, kind)| match wanted {
        Some(wanted) => label == wanted,
        None => known(*kind),
    });
    let place = found.ok_or_else(|| StudyError::NoSpecial {
        wanted: wanted.map(str::to_owned),
        labels: all.iter().map(|(label, _)| label.clone()).collect(),
    })?;
    let (label, kind) = &all[place];
    if known(*kind) {
        Ok(place)
    } else {
        Err(not_followed(label, *kind))
    }
}

fn not_followed(label: &str, kind: Kind) -> StudyError {
    StudyError::NotFollowed {
        label: label.to_owned(),
        kind: kind.name(),
    }
}

/// Puts points into the user's own values.
#[derive(Clone, Copy)]
struct Reader {
    along: Along,
    and: Along,
}

impl Reader {
    /// The points of a curve, the special ones among them, and why it ended.
    fn curve<P>(
        &self,
        (walked, work): curve::Curve<P>,
        read: fn(&Self, &P) -> CurvePointRecord,
        still: fn(&P) -> Option<usize>,
    ) -> (Vec<CurvePointRecord>, Vec<SpecialCurvePoint>, Ended, Work) {
        let labels = labels(walked.located.iter().map(|found| found.kind));
        let special = walked
            .located
            .iter()
            .zip(labels)
            .map(|(found, label)| SpecialCurvePoint {
                kind: found.kind,
                label,
                branches: self.unfolded(found.kind, still(&found.point)),
                point: read(self, &found.point),
            });
        let special = special.collect();
        let points = walked.points.iter().map(|point| read(self, point));
        (
            points.collect(),
            special,
            Ended::of(&walked.ending, self.and),
            work,
        )
    }

    /// Along what branches appear or meet where a curve of folds stands still in this variable.
    fn unfolded(&self, kind: Kind, still: Option<usize>) -> Option<Along> {
        let other = match still? {
            0 => self.and,
            _ => self.along,
        };
        matches!(kind, Kind::IsolaCentre | Kind::Exchange).then_some(other)
    }

    fn point(&self, point: &CurvePoint) -> CurvePointRecord {
        let floquet = point.floquet();
        CurvePointRecord {
            p: self.along.value(point.p),
            q: self.and.value(point.q),
            state: point.orbit.place.state.clone(),
            period: point.orbit.period,
            multipliers: floquet.multipliers.clone(),
            residual: point.orbit.residual,
            test: point.test,
        }
    }

    /// Multipliers do not exist where the last event is a touch.
    fn graze(&self, point: &GrazingPoint) -> CurvePointRecord {
        CurvePointRecord {
            p: self.along.value(point.p),
            q: self.and.value(point.q),
            state: point.shot.state.clone(),
            period: point.shot.period,
            multipliers: Vec::new(),
            residual: point.residual,
            test: point.shot.rate,
        }
    }
}

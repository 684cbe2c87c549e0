//! The points of a curve as they are reported.

use super::record::{CurvePointRecord, CurveRecord, SpecialCurvePoint};
use crate::continuation::Kind;
use crate::curve::{self, BorderPoint, CriticalEquilibrium, CurvePoint};
use crate::field::Work;
use crate::shooting::Orbit;
use crate::study::ended::Ended;
use crate::study::label::labels;
use crate::study::question::Along;

/// Puts points into the user's own values.
#[derive(Clone, Copy)]
pub(super) struct Reader {
    pub(super) along: Along,
    pub(super) and: Along,
}

/// The points of a curve, the special ones among them, why it ended, and what it cost.
pub(super) type Read = (Vec<CurvePointRecord>, Vec<SpecialCurvePoint>, Ended, Work);

impl Reader {
    /// A curve of this kind that starts at the point of this label of a branch.
    pub(super) fn record<B>(
        &self,
        branch: B,
        (of, kind): (String, Kind),
        (points, special, ended, work): Read,
    ) -> CurveRecord<B> {
        CurveRecord {
            branch,
            along: self.along,
            and: self.and,
            of,
            kind,
            points,
            special,
            ended,
            work,
        }
    }

    /// What is reported of a curve.
    pub(super) fn curve<P>(
        &self,
        (walked, work): curve::Curve<P>,
        read: fn(&Self, &P) -> CurvePointRecord,
        still: fn(&P) -> Option<usize>,
    ) -> Read {
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
            Ended::of(&walked.ending, self.and, None),
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

    /// Both variables in the user's own values.
    fn at(&self, [p, q]: [f64; 2]) -> [f64; 2] {
        [self.along.value(p), self.and.value(q)]
    }

    pub(super) fn orbit(&self, point: &CurvePoint<Orbit>) -> CurvePointRecord {
        let floquet = point.floquet();
        let at = self.at([point.p, point.q]);
        let met = [point.of.residual, point.test];
        CurvePointRecord {
            period: Some(point.of.period),
            multipliers: floquet.multipliers.clone(),
            ..CurvePointRecord::bare(at, &point.of.place.state, met)
        }
    }

    /// Multipliers do not exist where the last event is a touch.
    pub(super) fn border(&self, point: &BorderPoint) -> CurvePointRecord {
        let at = self.at([point.p, point.q]);
        let met = [point.residual, point.shot.rate];
        CurvePointRecord {
            period: Some(point.shot.period),
            ..CurvePointRecord::bare(at, &point.shot.state, met)
        }
    }

    pub(super) fn equilibrium(&self, point: &CurvePoint<CriticalEquilibrium>) -> CurvePointRecord {
        let at = self.at([point.p, point.q]);
        let met = [point.of.residual, point.test];
        CurvePointRecord {
            period: point
                .of
                .frequency()
                .map(|omega| std::f64::consts::TAU / omega),
            eigenvalues: point.of.spectrum.eigenvalues.clone(),
            l1: point.of.onset.map(|onset| onset.coefficient),
            l1_error: point.of.onset.map(|onset| onset.error),
            onset: point.of.onset.and_then(|onset| onset.name()),
            ..CurvePointRecord::bare(at, &point.of.place.state, met)
        }
    }
}

impl CurvePointRecord {
    /// A state that meets its equations and the condition so well.
    fn bare([p, q]: [f64; 2], state: &[f64], [residual, test]: [f64; 2]) -> Self {
        Self {
            p,
            q,
            period: None,
            state: state.to_vec(),
            multipliers: Vec::new(),
            eigenvalues: Vec::new(),
            l1: None,
            l1_error: None,
            onset: None,
            residual,
            test,
        }
    }
}

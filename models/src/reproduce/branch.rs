//! A branch of orbits as the report tells of it.

use std::time::Duration;

use stickslip::continuation::Kind;
use stickslip::field::Work;
use stickslip::study::{Along, BranchRecord, OrbitRecord};

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

impl Branch {
    /// What is told of a branch, found in this time.
    pub(super) fn of(record: BranchRecord, time: Duration) -> Self {
        let fold = record.special.iter().find(|point| point.kind == Kind::Fold);
        let special = record.special.last().map_or(f64::NAN, |point| point.r);
        let last = record.points.last().map_or(f64::NAN, at);
        let (r, why) = match (fold, record.ended.word()) {
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

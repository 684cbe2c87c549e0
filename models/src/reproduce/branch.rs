//! A branch of orbits as the report tells of it.

use std::time::Duration;

use stickslip::continuation::Kind;
use stickslip::field::Work;
use stickslip::report::numerals::{count, duration, short};
use stickslip::study::{Along, BranchRecord, OrbitRecord};

/// A branch as far as its first fold, and what it cost.
pub(super) struct Branch {
    along: Along,
    pub(super) points: Vec<OrbitRecord>,
    /// Where it ends.
    pub(super) end: f64,
    /// Why it ends there.
    why: &'static str,
    time: Duration,
    work: Work,
}

/// Why a branch ends that turns back, for which alone it is interrupted: also in a fold that is sharper than is told.
const MEETS: &str = "meets an unstable cycle";
/// Why a branch ends whose cycle becomes an equilibrium.
const VANISHES: &str = "shrinks to the equilibrium";

/// How many points there are up to the farthest.
fn farthest(record: &BranchRecord) -> usize {
    let way = (record.along.to - record.along.from).signum();
    let far = |point: &OrbitRecord| way * at(point);
    let all = record.points.iter().enumerate();
    let farthest = all.max_by(|a, b| far(a.1).total_cmp(&far(b.1)));
    farthest.map_or(0, |(place, _)| place + 1)
}

impl Branch {
    /// What is told of a branch, found in this time.
    pub(super) fn of(record: BranchRecord, time: Duration) -> Self {
        let fold = record.special.iter().find(|point| point.kind == Kind::Fold);
        let special = record.special.last().map_or(f64::NAN, |point| point.r);
        let last = record.points.last().map_or(f64::NAN, at);
        let turned = (record.ended.word() == "interrupted").then(|| farthest(&record));
        let tip = fold.map(|fold| fold.after).or(turned);
        let tip = tip.unwrap_or(record.points.len());
        let (end, why) = match (fold, record.ended.word()) {
            (Some(fold), _) => (fold.r, MEETS),
            (None, "interrupted") => (record.points[..tip].last().map_or(last, at), MEETS),
            (None, "reached-end") => (last, "end of the range"),
            (None, "equilibrium") => (last, VANISHES),
            (None, "hopf") => (special, VANISHES),
            (None, "grazing-sliding") => (special, "comes to rest for an instant (grazing)"),
            (None, "step-too-small") => (last, "steps too small"),
            (None, other) => (last, other),
        };
        let work = work(&record.points);
        let mut points = record.points;
        points.truncate(tip);
        Self {
            along: record.along,
            points,
            end,
            why,
            time,
            work,
        }
    }

    /// Where it ends, and why.
    pub(super) fn ending(&self) -> [String; 2] {
        [short(self.end), self.why.to_owned()]
    }

    /// What it cost along `name`, beside what it cost in the thesis, as a row of a table.
    pub(super) fn cost(&self, name: &str, thesis: &str) -> Vec<String> {
        let Self { along, work, .. } = self;
        vec![
            format!("{name} from {} to {}", along.from, along.to),
            count(self.points.len() as u64),
            count(work.steps),
            count(work.evaluations),
            count(work.linearisations),
            count(work.factorisations),
            count(work.newton),
            duration(self.time),
            thesis.to_owned(),
        ]
    }

    /// Where its cycle vanishes, if it does.
    pub(super) fn vanishes(&self) -> Option<f64> {
        (self.why == VANISHES).then_some(self.end)
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

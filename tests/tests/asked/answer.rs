//! Answers about one branch, and whether two of them say the same.

use stickslip::study::{BranchRecord, Special};

/// Distance of a special point from an end of a range, relative to its value, at which it may be on either side.
const BORDERLINE: f64 = 1e-5;

/// Error of one, relative to its value, whose error was not measured.
const UNMEASURED: f64 = 1e-6;

/// A branch as it was answered.
pub(crate) struct Answer {
    pub(crate) record: BranchRecord,
    /// The warning with which it ended.
    pub(crate) undecided: Option<String>,
}

impl Answer {
    pub(crate) fn of(record: BranchRecord) -> Self {
        let undecided = record.unlocated().map(|ended| ended.reason.clone());
        Self { record, undecided }
    }

    fn range(&self) -> [f64; 2] {
        let along = self.record.along;
        [along.from.min(along.to), along.from.max(along.to)]
    }

    /// The special points before the branch first leaves this range.
    fn within(&self, [low, high]: [f64; 2]) -> Vec<&Special> {
        let inside = |r: f64| r >= low && r <= high;
        let points = &self.record.points;
        let left = points.iter().position(|point| !point.r.is_some_and(inside));
        let left = left.unwrap_or(points.len());
        let special = self.record.special.iter();
        special
            .filter(|one| one.after <= left && inside(one.r))
            .collect()
    }
}

/// What one answer says and the other does not.
pub(crate) fn compare(first: &Answer, other: &Answer, way: &str) -> Option<String> {
    let [a, b] = [first.range(), other.range()];
    let range = [a[0].max(b[0]), a[1].min(b[1])];
    let (one, two) = if way == "far end" {
        (first.within(range), other.within(range))
    } else {
        (
            first.record.special.iter().collect(),
            other.record.special.iter().collect(),
        )
    };
    let (mut missing, mut extra) = (without(&one, &two), without(&two, &one));
    let borderline = |special: &Special| {
        let near = |end: f64| (special.r - end).abs() <= BORDERLINE * end.abs();
        range.iter().any(|end| near(*end))
    };
    missing.retain(|one| !borderline(one));
    extra.retain(|one| !borderline(one));
    let told = |all: &[&Special]| {
        let one = |one: &&Special| {
            let error = one.error.map(|error| format!(" ({error:.0e})"));
            format!("{} {:.11}{}", one.label, one.r, error.unwrap_or_default())
        };
        all.iter().map(one).collect::<Vec<_>>().join(", ")
    };
    let ends = [first, other].map(|one| one.record.ended.reason.clone());
    (!missing.is_empty() || !extra.is_empty()).then(|| {
        format!(
            "\n  missing [{}] more [{}] of [{}] ({:?})",
            told(&missing),
            told(&extra),
            told(&one),
            ends
        )
    })
}

/// Those of `all` that are not among `others`.
fn without<'a>(all: &[&'a Special], others: &[&'a Special]) -> Vec<&'a Special> {
    let mut left: Vec<&Special> = others.to_vec();
    let mut missing = Vec::new();
    for one in all {
        match left.iter().position(|other| same(one, other)) {
            Some(place) => {
                left.remove(place);
            }
            None => missing.push(*one),
        }
    }
    missing
}

/// One point, to the sum of its estimated errors.
fn same(a: &Special, b: &Special) -> bool {
    let error = |one: &Special| one.error.unwrap_or(UNMEASURED * one.r.abs());
    a.kind == b.kind && (a.r - b.r).abs() <= error(a) + error(b)
}

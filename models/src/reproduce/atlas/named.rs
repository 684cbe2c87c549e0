//! The bifurcations that the thesis names, beside ours.

use stickslip::continuation::Kind;
use stickslip::report::numerals::decimals;
use stickslip::study::{BranchRecord, Special};

use super::{Atlas, FAMILIES};

/// A bifurcation of section 3.3.2.
pub(super) struct Named {
    family: usize,
    /// The flips at which to leave the first branch, and those that leave it, as the thesis prints them.
    path: &'static [f64],
    kind: Kind,
    /// As the thesis prints it.
    v_dr: f64,
}

const fn named(family: usize, path: &'static [f64], kind: Kind, v_dr: f64) -> Named {
    Named {
        family,
        path,
        kind,
        v_dr,
    }
}

static NAMED: [Named; 18] = [
    named(0, &[], Kind::Flip, 0.081),
    named(0, &[], Kind::Flip, 0.141),
    named(0, &[0.081], Kind::Flip, 0.08),
    named(0, &[0.141], Kind::Fold, 0.165),
    named(1, &[], Kind::Flip, 0.25),
    named(1, &[0.25], Kind::Fold, 0.32),
    named(1, &[0.25], Kind::Flip, 0.29),
    named(1, &[0.25], Kind::Flip, 0.25),
    named(1, &[0.25], Kind::Flip, 0.144),
    named(1, &[0.25, 0.144], Kind::Flip, 0.132),
    named(1, &[0.25, 0.144], Kind::Flip, 0.113),
    named(1, &[0.25, 0.144], Kind::Fold, 0.104),
    named(1, &[0.25, 0.144], Kind::Fold, 0.1112),
    named(1, &[0.25, 0.144], Kind::Flip, 0.1106),
    named(2, &[], Kind::Fold, 0.2864),
    named(2, &[], Kind::Fold, 0.263),
    named(2, &[], Kind::Flip, 0.274),
    named(2, &[], Kind::Flip, 0.2858),
];

/// The bifurcation in both systems.
pub(super) struct Match<'a> {
    pub(super) named: &'a Named,
    pub(super) smoothed: Option<&'a Special>,
    pub(super) exact: Option<&'a Special>,
    period_count: usize,
}

/// Each named bifurcation where the copy has it next to the printed digits, and the one that corresponds to
/// it in the exact system: reached by the same flips, and of the same kind and number on its branch.
pub(super) fn matches<'a>(smoothed: &'a Atlas, exact: &'a Atlas) -> Vec<Match<'a>> {
    let one = |named: &'a Named| {
        let first = [smoothed, exact].map(|atlas| &atlas.families[named.family]);
        let pair = named
            .path
            .iter()
            .try_fold(first, |pair, flip| flips(pair, *flip));
        let near = pair.and_then(|pair| nearest(pair[0], named.kind, named.v_dr));
        let exact = pair.zip(near);
        let orbit = pair.and_then(|pair| pair[0].points.first());
        Match {
            named,
            smoothed: near,
            exact: exact.and_then(|(pair, special)| counterpart(pair, special, named.family)),
            period_count: orbit.map_or(0, |orbit| orbit.period_count),
        }
    };
    NAMED.iter().map(one).collect()
}

/// The branches that leave both at the flip that the copy has next to this speed.
fn flips(pair: [&BranchRecord; 2], v_dr: f64) -> Option<[&BranchRecord; 2]> {
    let label = nearest(pair[0], Kind::Flip, v_dr)?.label.as_str();
    let [a, b] = pair.map(|branch| {
        let mut below = branch.branches.iter();
        below.find(|below| below.from.as_deref() == Some(label))
    });
    Some([a?, b?])
}

fn nearest(branch: &BranchRecord, kind: Kind, v_dr: f64) -> Option<&Special> {
    let same = branch.special.iter().filter(|special| special.kind == kind);
    same.min_by(|a, b| (a.r - v_dr).abs().total_cmp(&(b.r - v_dr).abs()))
}

fn counterpart<'a>(
    [smoothed, exact]: [&'a BranchRecord; 2],
    special: &Special,
    family: usize,
) -> Option<&'a Special> {
    if FAMILIES[family].name != "closed" {
        return exact
            .special
            .iter()
            .find(|other| other.label == special.label);
    }
    // A closed branch has no first point, but a leftmost one and a rightmost one.
    let sorted = |branch: &'a BranchRecord| {
        let same = branch
            .special
            .iter()
            .filter(|other| other.kind == special.kind);
        let mut all: Vec<&Special> = same.collect();
        all.sort_by(|a, b| a.r.total_cmp(&b.r));
        all
    };
    let (ours, theirs) = (sorted(smoothed), sorted(exact));
    let place = ours.iter().position(|other| other.label == special.label)?;
    if place + 1 == ours.len() {
        return theirs.last().copied();
    }
    (place == 0).then(|| theirs.first().copied()).flatten()
}

/// A row for each named bifurcation.
pub(super) fn rows(smoothed: &Atlas, exact: &Atlas) -> Vec<Vec<String>> {
    let number = |special: Option<&Special>| special.map_or("–".to_owned(), |s| decimals(s.r, 6));
    let row = |found: Match<'_>| {
        let shift = found.smoothed.zip(found.exact).map(|(a, b)| a.r - b.r);
        let criticality = found.smoothed.and_then(|special| special.criticality);
        vec![
            FAMILIES[found.named.family].name.to_owned(),
            found.period_count.to_string(),
            found.named.kind.to_string(),
            found.named.v_dr.to_string(),
            number(found.smoothed),
            number(found.exact),
            shift.map_or("–".to_owned(), |shift| decimals(shift, 6)),
            criticality.unwrap_or_default().to_owned(),
        ]
    };
    matches(smoothed, exact).into_iter().map(row).collect()
}

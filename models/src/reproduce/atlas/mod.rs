//! Thesis section 3.3.2: all branches of two coupled masses on one belt, smoothed and exact.

mod drawn;
mod named;
mod page;

use std::time::{Duration, Instant};

use stickslip::field::Kernel;
use stickslip::report::numerals::{count, duration};
use stickslip::report::{Manuscript, Section};
use stickslip::study::{Beginning, BranchRecord, Case, Dynamics, Switch, parallel};

use super::ReproduceError;
use super::ask::Subject;
use super::branch::work;
use super::copies::copy;
use crate::BeltPair;

/// The copy is of size 10ⁱ.
const EXPONENT: i32 = 5;
/// The speeds of the belt between which branches are followed.
const RANGE: [f64; 2] = [0.065, 0.5];
const ACCURACY: f64 = 1e-9;

/// A family of branches: where it begins, and how many switches deep it is followed.
#[derive(Clone, Copy)]
struct Family {
    name: &'static str,
    v_dr: f64,
    start: [f64; 4],
    period: Option<f64>,
    depth: usize,
}

const FAMILIES: [Family; 3] = [
    Family {
        name: "in phase",
        v_dr: 0.14,
        start: [-0.5976, 0.0, -0.4604, -0.1607],
        period: Some(16.14),
        depth: 1,
    },
    Family {
        name: "out of phase",
        v_dr: 0.35,
        start: [-0.02798, 0.0, 0.678, 0.3089],
        period: Some(4.211),
        depth: 3,
    },
    Family {
        name: "closed",
        v_dr: 0.27,
        start: [-0.21967, 0.0, 0.68379, -0.02510],
        period: None,
        depth: 1,
    },
];

/// The branches of one system.
struct Atlas {
    dynamics: Dynamics,
    families: Vec<BranchRecord>,
    time: Duration,
}

/// The section on the branches of the belt pair, and how many branches there are.
pub(super) fn section() -> Result<(Section, usize), ReproduceError> {
    let pair = Subject::new(BeltPair::v_dr);
    let smoothed = follow(&pair, copy(Kernel::Arctan, EXPONENT))?;
    let exact = follow(&pair, Dynamics::Exact)?;
    let branches = smoothed.branches().count() + exact.branches().count();
    let both = [&smoothed, &exact];
    let manuscript = Manuscript::new(include_str!("atlas.md"))
        .page(page::page(&pair, &smoothed, &exact))
        .rows("atlas-bifurcations", named::rows(&smoothed, &exact))
        .rows("atlas-cost", both.map(costs))
        .panels(
            "3.15",
            drawn::panels(
                both,
                "*f*",
                (
                    |orbit| 1.0 / orbit.period,
                    |special| 1.0 / (special.turns as f64 * special.period),
                ),
            ),
        )
        .panels(
            "3.17",
            drawn::panels(
                both,
                "max |*X*_{1}|",
                (|orbit| orbit.max_abs[0], |special| special.max_abs[0]),
            ),
        )
        .panels("3.18", drawn::points(both));
    Ok((manuscript.section()?, branches))
}

/// Follows all families, on all cores.
fn follow(pair: &Subject, dynamics: Dynamics) -> Result<Atlas, ReproduceError> {
    let clock = Instant::now();
    // The longest first, so that no core waits for it.
    let mut order: Vec<usize> = (0..FAMILIES.len()).collect();
    order.sort_by_key(|&i| std::cmp::Reverse(FAMILIES[i].depth));
    let found = parallel(&order, |&i| {
        Ok((i, branches(pair, &FAMILIES[i], dynamics)?))
    });
    let found = found.into_iter();
    let mut families: Vec<(usize, BranchRecord)> = found.collect::<Result<_, ReproduceError>>()?;
    families.sort_by_key(|(i, _)| *i);
    Ok(Atlas {
        dynamics,
        families: families.into_iter().map(|(_, branch)| branch).collect(),
        time: clock.elapsed(),
    })
}

fn branches(
    pair: &Subject,
    family: &Family,
    dynamics: Dynamics,
) -> Result<BranchRecord, ReproduceError> {
    let case = Case {
        along: Some(pair.along(RANGE[0], RANGE[1])),
        beginning: Beginning::At(family.v_dr),
        start: Some(family.start.to_vec()),
        period: family.period,
        accuracy: ACCURACY,
        switch: Switch {
            flips: true,
            branch_points: false,
            depth: family.depth,
        },
        ..pair.case(dynamics, family.v_dr)
    };
    pair.branches(&case)
}

impl Atlas {
    /// All branches, each with the name of its family.
    fn branches(&self) -> impl Iterator<Item = (&'static str, &BranchRecord)> {
        let named = FAMILIES.iter().zip(&self.families);
        named.flat_map(|(family, first)| first.all().into_iter().map(|b| (family.name, b)))
    }

    fn title(&self) -> &'static str {
        match self.dynamics {
            Dynamics::Exact => "exact",
            _ => "smoothed, *ε* = 10^{5}",
        }
    }
}

fn costs(atlas: &Atlas) -> Vec<String> {
    let all: Vec<&BranchRecord> = atlas.branches().map(|(_, branch)| branch).collect();
    let points = all.iter().flat_map(|branch| &branch.points);
    let work = work(points.clone());
    let special: usize = all.iter().map(|branch| branch.special.len()).sum();
    vec![
        atlas.title().to_owned(),
        count(all.len() as u64),
        count(points.count() as u64),
        count(special as u64),
        count(work.steps),
        count(work.evaluations),
        count(work.factorisations),
        count(work.newton),
        duration(atlas.time),
    ]
}

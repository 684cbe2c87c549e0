//! Branches of doubled orbits: they go once around, and not back over themselves.

use stickslip::study::{BranchRecord, Special};
use stickslip_tests::random::Random;

use crate::question::Question;

/// Random branches of which some have flips.
const BRANCHES: u64 = 40;
/// Relative difference of two orbits that are one.
const SAME: f64 = 1e-6;

fn one(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME * a.abs().max(b.abs())
}

/// Two special points of one branch that are one.
fn twice(branch: &BranchRecord) -> Option<[&Special; 2]> {
    let same = |a: &Special, b: &Special| {
        let extents = || a.max_abs.iter().zip(&b.max_abs).all(|(a, b)| one(*a, *b));
        a.kind == b.kind && one(a.r, b.r) && one(a.period, b.period) && extents()
    };
    let all = branch.special.iter().enumerate();
    let mut pairs = all.flat_map(|(i, a)| branch.special[i + 1..].iter().map(move |b| [a, b]));
    pairs.find(|[a, b]| same(a, b))
}

#[test]
#[ignore = "long"]
fn doubled_branches_do_not_walk_back() {
    let mut seen = 0;
    for seed in 0..BRANCHES {
        let question = Question::random(&mut Random::new(seed)).with_doubled();
        let Some(answer) = question.answer() else {
            continue;
        };
        for branch in &answer.record.branches {
            seen += 1;
            println!("{seed}: {}, {}", branch.special.len(), branch.ended.reason);
            let pair = twice(branch).map(|pair| pair.map(|one| (&one.label, one.r, one.period)));
            assert_eq!(pair, None, "{seed}: {question}: {}", branch.ended.reason);
        }
    }
    assert!(seen > 1, "{seen} doubled branches");
}

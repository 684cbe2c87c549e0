//! Branches of the motions that starts have found: closed ones without being told where they are.

use stickslip::study::{
    Along, AttractorsRecord, Case, Design, Followed, FollowedRecord, Kind, Sampling, System, choose,
};
use stickslip_tests::rotating::Rotating;

use crate::shares::region;

/// How far Ω goes from 1 + b s at this s, on both sides; NaN where no orbit is so large.
fn half_width(s: f64) -> f64 {
    (0.25_f64.powi(2) / s - (0.152 + (s - 1.0).powi(2)).powi(2)).sqrt()
}

/// The largest value of a function with one maximum between two places.
fn largest(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    for _ in 0..200 {
        let [a, b] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
        match f(a) < f(b) {
            true => low = a,
            false => high = b,
        }
    }
    f(low)
}

fn followed(
    system: &System,
    along: Along,
    sampling: &Sampling,
) -> (AttractorsRecord, FollowedRecord) {
    let case = Case::declared(system.info(), choose(system.info(), None, 1e-9).dynamics);
    let case = Case {
        along: Some(along),
        ..case.at(along.from)
    };
    let record = system.attractors(&case, sampling).unwrap();
    let followed = system.followed(&case, &record).unwrap();
    (record, followed)
}

fn folds(one: &Followed) -> Vec<f64> {
    let folds = one
        .branch
        .special
        .iter()
        .filter(|one| one.kind == Kind::Fold);
    let mut folds: Vec<f64> = folds.map(|one| one.r).collect();
    folds.sort_by(f64::total_cmp);
    folds
}

#[test]
fn an_isola_is_found_beside_the_branch_that_goes_through() {
    let system = System::of::<Rotating, _>();
    let sides = [("x", -1.2, 1.2), ("v", -1.2, 1.2)];
    let sampling = Sampling {
        values: 5,
        ..Sampling::of(region(system.info(), &sides), 12)
    };
    let along = Along {
        design: Design::Parameter(Rotating::omega.index),
        from: 0.6,
        to: 1.6,
    };
    let (record, found) = followed(&system, along, &sampling);
    let [through, isola] = &found.branches[..] else {
        panic!("{found:?}");
    };
    assert!(!through.is_isola() && through.span() == [0.6, 1.6]);
    assert_eq!(through.motions.len(), 5);
    assert!(isola.is_isola() && !isola.motions.is_empty(), "{isola:?}");
    let all: usize = record.surveys.iter().map(|survey| survey.found.len()).sum();
    assert_eq!(all, through.motions.len() + isola.motions.len());
    assert!(found.failed.is_empty());
    let right = largest(|s| 1.0 + 0.1 * s + half_width(s), 0.6, 1.25);
    let left = -largest(|s| half_width(s) - 1.0 - 0.1 * s, 0.6, 1.25);
    let [low, high] = folds(isola)[..] else {
        panic!("{:?}", isola.branch.special);
    };
    assert!(
        (low - left).abs() < 1e-8 && (high - right).abs() < 1e-8,
        "{low} {left} {high} {right}"
    );
    assert_eq!(isola.span(), [low, high]);
    // Each point obeys the closed form.
    for orbit in [through, isola].iter().flat_map(|one| &one.branch.points) {
        let s = orbit.max[0].powi(2);
        let off = (orbit.r.unwrap() - 1.0 - 0.1 * s).abs() - half_width(s);
        let steep = (1.0 / half_width(s)).max(1.0);
        assert!(off.abs() < 1e-6 * steep, "{orbit:?} {off}");
    }
}

//! Branches of orbits of the reference systems.

use stickslip::bifurcation::Stability;
use stickslip::continuation::{Settings, Stop};
use stickslip::field::Design;
use stickslip::integrate::Tolerance;
use stickslip::model;
use stickslip::model::Model;
use stickslip::shooting::{Orbit, OrbitBranch, OrbitError, Search, closest};
use stickslip_models::friction::Coulomb;
use stickslip_models::{BeltOscillator, DrillString};
use stickslip_tests::branches::branch;
use stickslip_tests::on_every_reference_system;
use stickslip_tests::subject::{self, Subject};

model! {
    /// A mass that is driven by its own speed and held back by the ground.
    struct Driven {
        state x = 1.2;
        state v = 0.0;
        param zeta = 0.1;
        param level = 0.2 where level >= 0.0;
        friction F = Coulomb { level: level } opposing v;
        der(x) = v;
        der(v) = 2 * zeta * v - x + F;
    }
}

on_every_reference_system! {
    a_branch_there_and_back_closes,
    a_branch_ends_on_the_orbit_that_is_found_there,
    a_longer_range_only_adds_points,
}

const ACCURACY: f64 = 1e-9;

/// Every orbit from `from` to `to`, and why there are no more.
fn follow<M: Model<N>, const N: usize>(
    subject: &Subject<M, N>,
    design: Design,
    (from, to): (f64, f64),
    first: Option<&Orbit>,
) -> (Vec<Orbit>, String) {
    let family = subject.family(design, Tolerance::for_accuracy(ACCURACY));
    let search = search(subject);
    let found;
    let first = match first {
        Some(orbit) => orbit,
        None => {
            found = closest(&family, from, &search).expect("a first orbit");
            &found
        }
    };
    let settings = Settings::new(from, to, ACCURACY);
    let mut branch = OrbitBranch::start(&family, first, &search, settings).expect("a branch");
    let orbits: Vec<_> = branch.by_ref().take(60).collect();
    let ending = match branch.stop() {
        Some(Stop::ReachedEnd) => "end".to_owned(),
        Some(Stop::ReachedStart) => "start".to_owned(),
        other => format!("{other:?}"),
    };
    (orbits, ending)
}

fn search<M: Model<N>, const N: usize>(subject: &Subject<M, N>) -> Search {
    Search {
        accuracy: ACCURACY,
        ..subject.search()
    }
}

fn same(a: &Orbit, b: &Orbit) {
    assert!(
        (a.period / b.period - 1.0).abs() < 1e-7,
        "{} against {}",
        a.period,
        b.period
    );
    for j in 0..a.max.len() {
        let gap = (a.max[j] - b.max[j]).abs() / (b.max[j] - b.min[j]);
        assert!(gap < 1e-7, "maximum of state {j} is {gap:e} off");
    }
}

/// The last parameter of the declaration, and a few percent more of it.
fn span<M: Model<N>, const N: usize>(subject: &Subject<M, N>) -> (Design, f64, f64) {
    let values = subject.model.values();
    let last = values.as_ref().len() - 1;
    let value = values.as_ref()[last];
    (Design::Parameter(last), value, 0.96 * value)
}

fn a_branch_there_and_back_closes<M: Model<N>, const N: usize>(subject: &Subject<M, N>) {
    let (design, from, to) = span(subject);
    let (there, ending) = follow(subject, design, (from, to), None);
    assert_eq!(ending, "end");
    assert!(there.len() >= 2);
    let (back, ending) = follow(subject, design, (to, from), there.last());
    assert_eq!(ending, "end");
    same(&back[back.len() - 1], &there[0]);
}

fn a_branch_ends_on_the_orbit_that_is_found_there<M: Model<N>, const N: usize>(
    subject: &Subject<M, N>,
) {
    let (design, from, to) = span(subject);
    let (branch, _) = follow(subject, design, (from, to), None);
    let last = &branch[branch.len() - 1];
    assert_eq!(last.r, to);
    let family = subject.family(design, Tolerance::for_accuracy(ACCURACY));
    same(
        &closest(&family, to, &search(subject)).expect("an orbit"),
        last,
    );
}

fn a_longer_range_only_adds_points<M: Model<N>, const N: usize>(subject: &Subject<M, N>) {
    let (design, from, to) = span(subject);
    let far = from + 3.7 * (to - from);
    let (near, _) = follow(subject, design, (from, to), None);
    let (long, _) = follow(subject, design, (from, far), None);
    let inside = &near[..near.len() - 1];
    assert!(inside.len() > 1 && long.len() > inside.len());
    for (a, b) in inside.iter().zip(&long) {
        assert_eq!((a.r, a.period), (b.r, b.period));
        assert_eq!(a.place.state, b.place.state);
    }
}

/// The drill string's cycle is lost in a fold, and the branch comes back unstable.
#[test]
fn a_branch_goes_on_through_a_fold() {
    let design = Design::Parameter(DrillString::eta.index);
    let (orbits, ending) = follow(&subject::drill_string(), design, (4.0, 8.0), None);
    let fold = orbits.iter().map(|orbit| orbit.r).fold(0.0, f64::max);
    let top = orbits
        .iter()
        .position(|orbit| orbit.r == fold)
        .expect("a largest r");
    assert!(
        (6.24154..6.24156).contains(&fold),
        "fold at {fold}: {ending}"
    );
    assert_eq!(orbits[0].floquet.stability, Stability::Stable);
    let after: Vec<_> = orbits[top + 2..].iter().collect();
    assert!(after.len() > 3, "the branch ends at its fold: {ending}");
    assert!(
        after
            .iter()
            .all(|orbit| orbit.floquet.stability == Stability::Unstable)
    );
    // At the fold a multiplier passes through 1.
    let near = orbits[top].floquet.multipliers[0].re;
    assert!((near - 1.0).abs() < 0.5, "{near}");
}

/// arctan 1e2 lets the belt oscillator come to rest at v_dr = 0.05: below its Hopf point at 0.05187.
#[test]
fn a_motion_that_comes_to_rest_is_reported_so() {
    let mut subject = subject::belt_oscillator();
    subject.smoothing = Some("arctan:1e2".parse().expect("a smoothing"));
    subject.model = BeltOscillator {
        v_dr: 0.05,
        ..Default::default()
    };
    let family = subject.family(Design::None, Tolerance::for_accuracy(ACCURACY));
    let found = closest(&family, 0.0, &search(&subject));
    assert!(
        matches!(found, Err(OrbitError::Equilibrium { .. })),
        "{found:?}"
    );
}

/// Friction reverses just where the first state is least, and orbits are said to begin. Between two turning points the
/// motion is linear about ∓level, and grows by g = exp(π ζ/√(1 − ζ²)): A = g (A − level) − level.
#[test]
fn a_branch_may_begin_where_friction_reverses() {
    let found = branch(&[], Driven::zeta, (0.1, 0.3), |case| {
        case.start = Some(vec![-1.3, 0.0]);
        case.period = Some(6.3);
    });
    let ended = found.points.last().and_then(|point| point.r);
    assert_eq!(ended, Some(0.3), "{}", found.ended.reason);
    for point in &found.points {
        let zeta = point.r.expect("a value");
        let root = (1.0 - zeta * zeta).sqrt();
        let g = (std::f64::consts::PI * zeta / root).exp();
        let amplitude = 0.2 * (g + 1.0) / (g - 1.0);
        let all = [
            (point.period, std::f64::consts::TAU / root),
            (point.max[0], amplitude),
            (point.min[0], -amplitude),
            (point.floquet.multipliers[0].re, g * g),
        ];
        for (value, right) in all {
            assert!(
                (value / right - 1.0).abs() < 1e-7,
                "{zeta}: {value}, {right}"
            );
        }
    }
}

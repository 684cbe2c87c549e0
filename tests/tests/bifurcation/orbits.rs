//! Bifurcations of orbits, where they are known in closed form or from an independent method.

use std::f64::consts::TAU;

use stickslip::field::Design;
use stickslip::model;
use stickslip::study::{Along, Beginning, BranchRecord, Case, Dynamics, Switch, System};

model! {
    /// A circle of radius² 1 ± √(1 + p) that two orbits share: they meet in a fold at p = −1.
    pub struct TwoCircles {
        state x = 1.5;
        state v = 0.0;
        param p = 0.5;
        let square = powi(x, 2) + powi(v, 2);
        der(x) = x * (p + 2.0 * square - powi(square, 2)) - v;
        der(v) = v * (p + 2.0 * square - powi(square, 2)) + x;
    }
}

model! {
    /// The unit circle, beside which two states turn by 1.3 rad a time unit and grow at the rate p.
    pub struct Torus {
        state x = 1.0;
        state v = 0.0;
        state u = 0.0;
        state w = 0.0;
        param p = -0.1;
        der(x) = x * (1.0 - powi(x, 2) - powi(v, 2)) - v;
        der(v) = v * (1.0 - powi(x, 2) - powi(v, 2)) + x;
        der(u) = p * u - 1.3 * w;
        der(w) = 1.3 * u + p * w;
    }
}

model! {
    /// The unit circle at the pace 1.7, beside which two modes of vibration couple: they collide at μ = 3/4, with equal
    /// dampers c at (3/4)(1 + 2 c²).
    pub struct Squealing {
        state x = 1.0;
        state v = 0.0;
        state p = 0.0;
        state q = 0.0;
        state dp = 0.0;
        state dq = 0.0;
        param mu = 0.3;
        param c = 0.0;
        der(x) = x * (1.0 - powi(x, 2) - powi(v, 2)) - 1.7 * v;
        der(v) = v * (1.0 - powi(x, 2) - powi(v, 2)) + 1.7 * x;
        der(p) = dp;
        der(q) = dq;
        der(dp) = -2.0 * p - (1.0 - mu * 4.0 / 3.0) * q - c * dp;
        der(dq) = -p - 2.0 * q - c * dq;
    }
}

model! {
    /// Two equal, undamped masses beside the unit circle, pressed against each other by p: their second mode buckles at
    /// p = 1, and its multipliers before that are double −1 and double 1 at times.
    pub struct Undamped {
        state x = 1.0;
        state v = 0.0;
        state a = 0.0;
        state b = 0.0;
        state da = 0.0;
        state db = 0.0;
        param p = -0.3;
        der(x) = x * (1.0 - powi(x, 2) - powi(v, 2)) - v;
        der(v) = v * (1.0 - powi(x, 2) - powi(v, 2)) + x;
        der(a) = da;
        der(b) = db;
        der(da) = -1.1 * a + p * (a - b);
        der(db) = -1.1 * b + p * (b - a);
    }
}

model! {
    /// The unit circle, beside which one state grows at the rate 0.1 and another decays at the rate p.
    pub struct Saddle {
        state x = 1.0;
        state v = 0.0;
        state u = 0.0;
        state w = 0.0;
        param p = 0.05;
        der(x) = x * (1.0 - powi(x, 2) - powi(v, 2)) - v;
        der(v) = v * (1.0 - powi(x, 2) - powi(v, 2)) + x;
        der(u) = 0.1 * u;
        der(w) = -p * w;
    }
}

model! {
    /// The unit circle in the middle of three from p = 0 on: a pitchfork.
    pub struct Pitchfork {
        state x = 1.0;
        state v = 0.0;
        state u = 0.0;
        param p = -0.1;
        der(x) = x * (1.0 - powi(x, 2) - powi(v, 2)) - v;
        der(v) = v * (1.0 - powi(x, 2) - powi(v, 2)) + x;
        der(u) = p * u - powi(u, 3);
    }
}

model! {
    /// A third state that follows the first round the unit circle, from p = 0 on beside it: the field changes sign with
    /// all states, so that an orbit can be its own image after half a period, and the other two are not.
    pub struct Escort {
        state x = 1.0;
        state v = 0.0;
        state u = 1.0;
        param p = -0.1;
        let pull = 1.0 - powi(x, 2) - powi(v, 2);
        let ahead = u - x;
        der(x) = x * pull - v;
        der(v) = v * pull + x;
        der(u) = x * pull - v + p * ahead - powi(ahead, 3);
    }
}

model! {
    /// The unit circle and another that changes places with it at p = 0: transcritical, and nothing is symmetric.
    pub struct Transcritical {
        state x = 1.0;
        state v = 0.0;
        state u = 0.0;
        param p = -0.1;
        der(x) = x * (1.0 - powi(x, 2) - powi(v, 2)) - v;
        der(v) = v * (1.0 - powi(x, 2) - powi(v, 2)) + x;
        der(u) = p * u - powi(u, 2);
    }
}

model! {
    /// Two equal oscillators in phase, which they leave at the rate p: exchanging them changes nothing.
    pub struct Twins {
        state x = 1.0;
        state v = 0.0;
        state y = 1.0;
        state w = 0.0;
        param p = -0.1;
        let own = 1.0 - powi(x, 2) - powi(v, 2);
        let other = 1.0 - powi(y, 2) - powi(w, 2);
        let apart = powi(x - y, 2) + powi(v - w, 2);
        let rate = 0.5 * p - apart;
        der(x) = x * own - v + rate * (x - y);
        der(v) = v * own + x + rate * (v - w);
        der(y) = y * other - w + rate * (y - x);
        der(w) = w * other + y + rate * (w - v);
    }
}

model! {
    /// Rössler (1976).
    pub struct Roessler {
        state x = 2.645_700_14;
        state y = 2.151_336_2;
        state z = 3.186_389_8;
        param a = 0.2;
        param b = 0.2;
        param c = 2.5;
        der(x) = -y - z;
        der(y) = x + a * y;
        der(z) = b + z * (x - c);
    }
}

model! {
    /// Prigogine and Lefever's Brusselator: its equilibrium x = a, y = b/a has a Hopf point at b = 1 + a².
    pub struct Brusselator {
        state x = 1.0;
        state y = 1.0;
        param a = 1.0;
        param b = 1.5;
        der(x) = a + powi(x, 2) * y - (b + 1.0) * x;
        der(y) = b * x - powi(x, 2) * y;
    }
}

const EVERYWHERE: Switch = Switch {
    flips: true,
    branch_points: true,
    depth: 3,
};

/// The branch of a model from its declared start, along its parameter of this number.
macro_rules! branch {
    ($model:ty, $parameter:expr, $from:expr, $to:expr, $period:expr) => {
        branch!($model, $parameter, $from, $to, $period, Switch::default())
    };
    ($model:ty, $parameter:expr, $from:expr, $to:expr, $period:expr, $switch:expr) => {{
        let model = System::of::<$model, _>();
        let states = model.info().states.iter().map(|state| state.start);
        let mut case = Case::declared(model.info(), Dynamics::Smooth);
        case.start = Some(states.collect());
        case.period = Some($period);
        case.parameters[$parameter] = $from;
        case.switch = $switch;
        case.along = Some(Along {
            design: Design::Parameter($parameter),
            from: $from,
            to: $to,
        });
        model.branch(&case).expect("a branch")
    }};
}

/// Its special points are these, to 1e-9 of the larger of their r and 1.
fn shows(branch: &BranchRecord, expected: &[(&str, f64)]) {
    let found: Vec<_> = branch
        .special
        .iter()
        .map(|s| (s.label.as_str(), s.r))
        .collect();
    let same = |((label, r), (name, value)): (&(&str, f64), &(&str, f64))| {
        label == name && (r - value).abs() <= 1e-9 * value.abs().max(1.0)
    };
    let agree = found.len() == expected.len() && found.iter().zip(expected).all(same);
    assert!(
        agree,
        "found {found:?}, not {expected:?}: {}",
        branch.ended.reason
    );
    assert!(branch.ended.is_located(), "{}", branch.ended.reason);
}

#[test]
fn a_fold_is_located_and_turned() {
    let branch = branch!(TwoCircles, 0, 0.5, -2.0, TAU);
    shows(&branch, &[("LP1", -1.0), ("HB1", 0.0)]);
    assert_eq!(branch.ended.word(), "hopf");
}

#[test]
fn a_pair_that_leaves_the_circle_is_a_torus_point() {
    shows(&branch!(Torus, 0, -0.1, 0.15, TAU), &[("NS1", 0.0)]);
}

#[test]
fn modes_that_couple_beside_an_orbit_collide_on_the_circle() {
    let branch = branch!(Squealing, 0, 0.3, 1.2, TAU / 1.7);
    shows(&branch, &[("KC1", 0.75)]);
    assert_eq!(branch.ended.word(), "reached-end");
    shows(
        &branch!(Squealing, 0, 1.2, 0.3, TAU / 1.7),
        &[("KC1", 0.75)],
    );
}

/// The closed form with c = 0.01 in both dampers, and no margin left.
#[test]
fn damped_modes_beside_an_orbit_lose_it_by_a_torus() {
    let model = System::of::<Squealing, _>();
    let mut case = Case::declared(model.info(), Dynamics::Smooth);
    case.start = Some(vec![1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    case.period = Some(TAU / 1.7);
    case.parameters = vec![0.3, 0.01];
    case.along = Some(Along {
        design: Design::Parameter(0),
        from: 0.3,
        to: 1.2,
    });
    let branch = model.branch(&case);
    shows(
        &branch.expect("a branch"),
        &[("NS1", 0.75 * (1.0 + 2.0 * 0.01 * 0.01))],
    );
}

#[test]
fn margins_of_stability_end_no_branch() {
    let branch = branch!(Undamped, 0, -0.3, 0.3, TAU);
    shows(&branch, &[]);
    assert_eq!(branch.ended.word(), "reached-end");
}

#[test]
fn a_neutral_saddle_is_no_torus_point() {
    shows(&branch!(Saddle, 0, 0.05, 0.3, TAU), &[]);
}

#[test]
fn a_pitchfork_breaks_a_symmetry_and_is_no_fold() {
    shows(&branch!(Pitchfork, 0, -0.1, 0.15, TAU), &[("SB1", 0.0)]);
}

#[test]
fn a_symmetry_after_half_a_period_is_broken() {
    shows(&branch!(Escort, 0, -0.1, 0.15, TAU), &[("SB1", 0.0)]);
}

#[test]
fn equals_that_part_break_a_symmetry() {
    shows(&branch!(Twins, 0, -0.1, 0.15, TAU), &[("SB1", 0.0)]);
}

#[test]
fn what_is_not_symmetric_breaks_no_symmetry() {
    shows(&branch!(Transcritical, 0, -0.1, 0.15, TAU), &[("BP1", 0.0)]);
}

/// The value is from DOP853 at 1e-13 with variational equations, and a root search on the multiplier.
#[test]
fn roesslers_cycle_doubles_its_period() {
    let branch = branch!(Roessler, 2, 2.5, 3.0, 5.748_991_18);
    shows(&branch, &[("PD1", 2.832_445_027_86)]);
    let multiplier = branch.special[0].multipliers[0];
    assert!((multiplier.re + 1.0).abs() < 1e-7, "{multiplier}");
}

/// A tighter accuracy finds the same point, only better.
#[test]
fn accuracy_loses_no_point() {
    let model = System::of::<Torus, _>();
    let mut case = Case::declared(model.info(), Dynamics::Smooth);
    (case.start, case.period) = (Some(vec![1.0, 0.0, 0.0, 0.0]), Some(TAU));
    case.along = Some(Along {
        design: Design::Parameter(0),
        from: -0.1,
        to: 0.15,
    });
    for accuracy in [1e-6, 1e-8, 1e-10] {
        case.accuracy = accuracy;
        let branch = model.branch(&case).expect("a branch");
        assert_eq!(branch.special.len(), 1, "at {accuracy:e}");
        assert!(branch.special[0].r.abs() <= accuracy);
    }
}

/// Both sides of the pitchfork: circles at the heights ±√p.
#[test]
fn the_branch_that_crosses_at_a_pitchfork_is_followed_both_ways() {
    let branch = branch!(Pitchfork, 0, -0.1, 0.15, TAU, EVERYWHERE);
    let [crossing] = branch.branches.as_slice() else {
        panic!("{} branches leave it", branch.branches.len());
    };
    assert_eq!(crossing.from.as_deref(), Some("SB1"));
    let heights = crossing
        .points
        .iter()
        .map(|point| (point.state[2], point.r.expect("r")));
    let error = |(height, r): (f64, f64)| (height * height - r).abs();
    assert!(heights.clone().map(error).fold(0.0, f64::max) < 1e-8);
    let (low, high) = heights.fold((0.0_f64, 0.0_f64), |(low, high), (height, _)| {
        (low.min(height), high.max(height))
    });
    let root = 0.15_f64.sqrt();
    assert!(
        (low + root).abs() < 1e-8 && (high - root).abs() < 1e-8,
        "{low}, {high}: {:?}, {:?}",
        crossing.ended,
        crossing.began
    );
}

/// The values are from DOP853 at 1e-12 with variational equations, Newton on each doubled orbit and a root
/// search on its multiplier. The distances between them shrink towards Feigenbaum's 4.669.
#[test]
fn roesslers_cascade_of_flips() {
    let first = branch!(Roessler, 2, 2.5, 4.3, 5.748_991_18, EVERYWHERE);
    let expected = [
        2.832_445_027_860,
        3.837_358_168_409,
        4.124_214_732_074,
        4.186_996_999_392,
    ];
    let mut flips = Vec::new();
    let mut branch = Some(&first);
    while let Some(here) = branch {
        let flip = here
            .special
            .iter()
            .find(|special| special.kind.name() == "flip");
        let flip = flip.unwrap_or_else(|| panic!("no flip on branch {}", flips.len()));
        assert_eq!(flip.criticality, Some("supercritical"));
        flips.push(flip.r);
        branch = here
            .branches
            .iter()
            .find(|below| below.from.as_ref() == Some(&flip.label));
    }
    assert_eq!(flips.len(), expected.len());
    for (found, value) in flips.iter().zip(expected) {
        assert!((found / value - 1.0).abs() < 1e-8, "{found}, not {value}");
    }
    let ratio = |i: usize| (flips[i + 1] - flips[i]) / (flips[i + 2] - flips[i + 1]);
    assert!((ratio(1) - 4.669).abs() < 0.15 && (ratio(1) - 4.669).abs() < (ratio(0) - 4.669).abs());
}

/// Near the Hopf point the period is 2π/a, and the square of the amplitude grows in proportion to b.
#[test]
fn orbits_begin_at_the_brusselators_hopf_point() {
    let model = System::of::<Brusselator, _>();
    let mut case = Case::declared(model.info(), Dynamics::Smooth);
    case.along = Some(Along {
        design: Design::Parameter(1),
        from: 1.5,
        to: 2.5,
    });
    case.beginning = Beginning::Hopf;
    let branch = model.branch(&case).expect("a branch");
    assert_eq!(branch.ended.word(), "reached-end");
    let extent = |i: usize| branch.points[i].max[0] - branch.points[i].min[0];
    let above = |i: usize| branch.points[i].r.expect("r") - 2.0;
    assert!(above(0) > 0.0 && above(0) < 1e-3, "{}", above(0));
    assert!((branch.points[0].period / TAU - 1.0).abs() < 1e-3);
    let growth = |i: usize| extent(i).powi(2) / above(i);
    assert!((growth(1) / growth(0) - 1.0).abs() < 0.02);
    assert!(
        branch
            .points
            .iter()
            .all(|point| point.floquet.unstable == 0)
    );
}

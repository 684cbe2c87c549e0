//! Orbits along which errors grow a hundred million times: divided into segments, they are followed as any other.

use nalgebra::DVector;
use stickslip::bifurcation::Stability;
use stickslip::continuation::{Settings, Stop, correct};
use stickslip::field::Design;
use stickslip::flow::{FlowError, SmoothFamily};
use stickslip::integrate::Tolerance;
use stickslip::model;
use stickslip::motion::Family;
use stickslip::shooting::{Orbit, OrbitBranch, OrbitProblem, Phase, Search, closest};
use stickslip::study::{Along, Case, Dynamics, Kind, System};
use stickslip_models::DrillString;
use stickslip_models::friction::LuGre;
use stickslip_tests::random::Random;

const ACCURACY: f64 = 1e-9;

fn family(accuracy: f64) -> Family {
    SmoothFamily {
        model: DrillString::default(),
        smoothing: "quartic:0.1".parse().ok(),
        design: Design::Parameter(DrillString::eta.index),
        tolerance: Tolerance::for_accuracy(accuracy),
        magnitude: [1.0; 2],
    }
    .into()
}

/// The branch that turns at eta = 6.24 and comes back along unstable orbits.
fn branch(accuracy: f64) -> (Vec<Orbit>, Option<Stop<FlowError>>) {
    let family = family(accuracy);
    let search = Search {
        start: vec![6.0, 0.0],
        modes: Vec::new(),
        period: None,
        accuracy,
        segments: 1,
    };
    let first = closest(&family, 4.0, &search).expect("a first orbit");
    let settings = Settings::new(4.0, 7.49, accuracy);
    let mut branch = OrbitBranch::start(&family, &first, &search, settings).expect("a branch");
    let orbits: Vec<Orbit> = branch.by_ref().collect();
    (orbits, branch.stop().cloned())
}

fn largest(orbit: &Orbit) -> f64 {
    let sizes = orbit.floquet.multipliers.iter().map(|mu| mu.norm());
    sizes.fold(0.0, f64::max)
}

/// The relative change of the largest multiplier with that of the period, at the end of a branch.
fn sensitivity(orbits: &[Orbit]) -> f64 {
    let [.., before, last] = orbits else {
        panic!("{} orbits", orbits.len())
    };
    let change = |of: fn(&Orbit) -> f64| (of(last) / of(before)).ln();
    (change(largest) / change(|orbit| orbit.period)).abs()
}

/// The last orbit is the same at another accuracy, its multiplier too, and the product of all multipliers is what
/// Liouville's formula makes it: no digit is lost on the way.
#[test]
fn an_unstable_branch_reaches_its_end() {
    let [(loose, stop), (tight, _)] = [ACCURACY, 1e-11].map(branch);
    assert!(matches!(stop, Some(Stop::ReachedStart)), "{stop:?}");
    let sensitivity = sensitivity(&loose);
    let [loose, tight] = [loose, tight].map(|mut orbits| orbits.pop().expect("an orbit"));
    assert!((loose.r - 4.0).abs() < 1e-12 && (tight.r - 4.0).abs() < 1e-12);
    assert!((loose.period / tight.period - 1.0).abs() < 10.0 * ACCURACY);
    assert!(largest(&loose) > 1e8, "{:?}", loose.floquet);
    // Multipliers are those of the last motion, one correction away from the orbit.
    let apart = largest(&loose) / largest(&tight) - 1.0;
    assert!(
        apart.abs() < 10.0 * sensitivity * ACCURACY,
        "{apart:e}, {sensitivity:e}"
    );
    assert!(sensitivity * ACCURACY < 1e-4, "{sensitivity:e}");
}

/// Stages of Gauss's collocation of order 6: their weights in the increment, and those that lead to each stage.
const ROOT: f64 = 3.872_983_346_207_417; // √15
const WEIGHTS: [f64; 3] = [5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0];
const STAGES: [[f64; 3]; 3] = [
    [
        5.0 / 36.0,
        2.0 / 9.0 - ROOT / 15.0,
        5.0 / 36.0 - ROOT / 30.0,
    ],
    [
        5.0 / 36.0 + ROOT / 24.0,
        2.0 / 9.0,
        5.0 / 36.0 - ROOT / 24.0,
    ],
    [
        5.0 / 36.0 + ROOT / 30.0,
        2.0 / 9.0 + ROOT / 15.0,
        5.0 / 36.0,
    ],
];

/// The field at a state, and its divergence.
type Rates<'a> = dyn Fn(&[f64]) -> (Vec<f64>, f64) + 'a;

/// A lap in so many steps of collocation, backwards: where it ends, and ∫ tr J dt forwards.
fn backwards(rates: &Rates<'_>, from: &[f64], period: f64, steps: usize) -> (Vec<f64>, f64) {
    let (mut state, mut growth) = (from.to_vec(), 0.0);
    let step = -period / steps as f64;
    for _ in 0..steps {
        let mut stages = [0; 3].map(|_| rates(&state));
        for _ in 0..12 {
            stages = STAGES.map(|row| {
                let moved = |j: usize| {
                    let terms = row.iter().zip(&stages);
                    state[j] + step * terms.map(|(a, (f, _))| a * f[j]).sum::<f64>()
                };
                rates(&(0..state.len()).map(moved).collect::<Vec<f64>>())
            });
        }
        for (weight, (f, trace)) in WEIGHTS.iter().zip(&stages) {
            let pairs = state.iter_mut().zip(f);
            pairs.for_each(|(y, rate)| *y += step * weight * rate);
            growth -= step * weight * trace;
        }
    }
    (state, growth)
}

/// Backwards such an orbit attracts: what is left of the first lap's errors is a hundred millionth. Collocation along it, which
/// knows nothing of shooting and its segments, finds its period, and by Liouville's formula its multiplier.
#[test]
fn an_unstable_orbit_is_the_attractor_of_its_past() {
    let (orbits, _) = branch(1e-11);
    let unstable: Vec<&Orbit> = orbits.iter().filter(|orbit| largest(orbit) > 1e6).collect();
    for orbit in unstable.iter().rev().step_by(unstable.len() / 4) {
        let flow = family(1e-12).at(orbit.r).expect("a flow");
        let rates = |state: &[f64]| {
            let place = flow.place(state).expect("a place");
            let velocity = flow.velocity(&place).expect("a field");
            (velocity.f.as_slice().to_vec(), velocity.jacobian.trace())
        };
        let lap = |from: &[f64]| backwards(&rates, from, orbit.period, 20_000);
        let (settled, _) = lap(&orbit.place.state);
        let (end, growth) = lap(&settled);
        // How much later it passes where it was, at its own speed.
        let (f, trace) = rates(&settled);
        let square: f64 = f.iter().map(|rate| rate * rate).sum();
        let off = f.iter().zip(end.iter().zip(&settled));
        let late = off.map(|(rate, (y, x))| rate * (y - x)).sum::<f64>() / square;
        assert!((late / orbit.period).abs() < 1e-9, "{late:e}");
        let [found, right] = [largest(orbit).ln(), growth + trace * late];
        assert!((found - right).abs() < 1e-6, "{found} {right}");
    }
}

#[test]
fn newton_is_quadratic_where_errors_grow() {
    let (orbits, _) = branch(ACCURACY);
    let unstable: Vec<&Orbit> = orbits.iter().filter(|orbit| largest(orbit) > 1e8).collect();
    assert!(unstable.len() >= 5);
    for orbit in unstable.iter().step_by(unstable.len() / 5).take(5) {
        let division = orbit.division.as_ref().expect("segments");
        let family = family(1e-12);
        let flow = family.at(orbit.r).expect("a flow");
        let velocity = flow.velocity(&division.starts[0]).expect("a field").f;
        let (start, magnitude) = (division.starts[0].state.clone(), orbit.magnitude());
        let phase = Phase::floating(None, start, &velocity, &magnitude);
        let mut problem =
            OrbitProblem::new(family, phase, division, orbit.period, magnitude.clone());
        let mut random = Random::new(7);
        let mut z = OrbitProblem::unknowns(&division.starts, orbit.period);
        for i in 0..z.len() - 1 {
            z[i] += 1e-5 * random.real(0.5) * magnitude[i % magnitude.len()];
        }
        let mut normal = DVector::zeros(z.len() + 1);
        normal[z.len()] = 1.0;
        let found = correct(&mut problem, z, orbit.r, &normal, 1.0, 1e-10).expect("convergence");
        let sizes = &found.corrections;
        assert!(sizes[0] > 1e-6, "{sizes:?}");
        // The layers of a smoothed contact are 0.1 wide: beyond that constant the corrections fall quadratically.
        for pair in sizes
            .windows(2)
            .filter(|pair| (1e-6..1e-4).contains(&pair[0]))
        {
            assert!(pair[1] <= 1e5 * pair[0] * pair[0], "{sizes:?}");
        }
        let last = sizes[sizes.len() - 1];
        assert!(sizes.len() <= 6 && last <= 1e-10, "{sizes:?}");
    }
}

model! {
    /// A seal that is drawn over a pin on a spring: bristles of half a millimetre beside slides of half a metre.
    pub struct Seal {
        state x: m = 0.0;
        state v: m/s = 0.0;
        state z: m = 0.0;
        param k: 1/s^2 = 2.0;
        param pull: m/s = 0.2;
        friction F: m/s^2 = LuGre { stiffness: 1e4, damping: 100.0, viscous: 0.4, peak: 1.5, kinetic: 1.0, stribeck: 0.01 } opposing pull - v with z;
        der(x) = v;
        der(v) = -F - k * x;
    }
}

/// Between folds and flips multipliers reach 1e13, and the trivial one is lost beside them: orbits are not called stable for
/// that, and where there is no symmetry there are no branch points.
#[test]
#[ignore = "long"]
fn what_grows_most_is_not_taken_for_what_underflows() {
    let system = System::of::<Seal, _>();
    let mut case = Case::declared(system.info(), Dynamics::Smooth);
    case.along = Some(Along {
        design: Design::Parameter(Seal::pull.index),
        from: 0.2,
        to: 0.5,
    });
    let branch = system.branch(&case).expect("a branch");
    let kinds = branch.special.iter().map(|one| one.kind);
    let kinds: Vec<Kind> = kinds.collect();
    assert!(kinds.len() >= 14, "{kinds:?}");
    let known = |kind: &Kind| matches!(kind, Kind::Fold | Kind::Flip);
    assert!(kinds.iter().all(known), "{kinds:?}");
    let mut behind = branch.points.iter().rev().take(20);
    assert!(behind.all(|orbit| {
        let growing = orbit.floquet.multipliers[0].norm() > 1e10;
        growing && orbit.floquet.stability == Stability::Unstable
    }));
}

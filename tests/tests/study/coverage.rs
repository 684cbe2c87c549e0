//! Error estimates are honest: the true error, known from a much tighter run, is below the estimate, and not far below.

use stickslip::field::{Kernel, Smoothing};
use stickslip::study::{Case, Dynamics, OrbitRecord, System};
use stickslip_models::systems::of_the_thesis;
use stickslip_tests::random::Random;

/// What came of many random questions.
#[derive(Debug, Default)]
struct Tally {
    asked: usize,
    answered: usize,
    /// Estimate over true error.
    ratios: Vec<f64>,
    missed: Vec<String>,
}

/// A random case of a random system, at a random accuracy.
fn random_case(dice: &mut Random) -> (System, Case) {
    const SIGNS: [Kernel; 5] = [
        Kernel::Arctan,
        Kernel::Tanh,
        Kernel::Algebraic,
        Kernel::Cubic,
        Kernel::Quintic,
    ];
    let which = (4.0 * dice.unit()) as usize;
    let system = of_the_thesis()[which].clone();
    let sign = SIGNS[(5.0 * dice.unit()) as usize];
    let copy = match which {
        0 => Some(Dynamics::Smooth),
        3 => Some(Dynamics::Smoothed(Smoothing {
            kernel: Kernel::Quartic,
            size: dice.positive(1e-6, 1e-1),
        })),
        _ => Some(Dynamics::Smoothed(Smoothing {
            kernel: sign,
            size: dice.positive(1e2, 1e8),
        })),
    };
    let smooth = which == 0 || dice.unit() < 0.5;
    let dynamics = copy.filter(|_| smooth).unwrap_or(Dynamics::Exact);
    let mut case = Case::declared(system.info(), dynamics);
    for value in &mut case.parameters {
        *value *= dice.positive(0.4, 2.5);
    }
    case.accuracy = dice.positive(1e-10, 1e-4);
    (system, case)
}

/// Largest relative difference of period and extrema.
fn difference(a: &OrbitRecord, b: &OrbitRecord) -> f64 {
    let extrema = |of: fn(&OrbitRecord) -> &Vec<f64>| {
        let pairs = of(a).iter().zip(of(b)).zip(&b.max_abs);
        pairs.map(|((x, y), size)| (x - y).abs() / size)
    };
    extrema(|orbit| &orbit.max)
        .chain(extrema(|orbit| &orbit.min))
        .fold((a.period / b.period - 1.0).abs(), f64::max)
}

fn ask(count: usize, seed: u64) -> Tally {
    let mut dice = Random::new(seed);
    let mut tally = Tally::default();
    for _ in 0..count {
        let (system, case) = random_case(&mut dice);
        tally.asked += 1;
        let Ok(orbit) = system.orbit(&case) else {
            continue;
        };
        let tight = Case {
            accuracy: 1e-12,
            start: Some(orbit.state.clone()),
            period: Some(orbit.period),
            ..case.clone()
        };
        let Ok(tight) = system.orbit(&tight) else {
            continue;
        };
        tally.answered += 1;
        let error = difference(&orbit, &tight);
        let doubt = tight.error_estimate.min(0.1 * orbit.error_estimate);
        if error > orbit.error_estimate + doubt {
            tally.missed.push(format!(
                "{} {} {:?} at {:.1e}: {error:.1e} > {:.1e}",
                system.info().command,
                case.dynamics,
                case.parameters,
                case.accuracy,
                orbit.error_estimate
            ));
        }
        tally.ratios.push(orbit.error_estimate / error.max(1e-15));
    }
    tally.ratios.sort_by(f64::total_cmp);
    tally
}

fn judge(tally: &Tally) {
    let median = tally.ratios[tally.ratios.len() / 2];
    println!(
        "{} asked, {} answered, {} below their error, median estimate/error {median:.1}\n{}",
        tally.asked,
        tally.answered,
        tally.missed.len(),
        tally.missed.join("\n")
    );
    assert!(
        2 * tally.answered > tally.asked,
        "few answers: {}",
        tally.answered
    );
    assert!(
        100 * tally.missed.len() <= tally.answered,
        "{:#?}",
        tally.missed
    );
    assert!(median <= 100.0, "estimates are {median} times too large");
}

#[test]
fn estimates_cover_the_errors_of_some_orbits() {
    judge(&ask(12, 2));
}

#[test]
#[ignore = "long"]
fn estimates_cover_the_errors_of_random_orbits() {
    judge(&ask(150, 1));
}

#[test]
#[ignore = "long"]
fn estimates_cover_the_errors_of_a_thousand_orbits() {
    judge(&ask(1000, 2));
}

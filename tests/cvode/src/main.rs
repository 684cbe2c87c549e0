//! Orbit flows with Φ and ∂φ/∂r by CVODES, beside ours in the same run: `cargo run --release` in this folder.

#[path = "../../benches/reference/clock.rs"]
mod clock;
mod cvodes;
#[allow(dead_code)]
#[path = "../../benches/reference/round.rs"]
mod round;

use std::time::Duration;

use stickslip::model::Model;

use round::{Round, Sensitivities, belt, belt_pair, drill_string, errors, van_der_pol};

/// Errors of Φ at which both are timed.
const WANTED: [f64; 4] = [1e-4, 1e-6, 1e-7, 1e-8];

fn main() {
    println!("once around with Φ and ∂φ/∂r: µs at an error of Φ of at most");
    let cells = WANTED.map(|error| format!("{error:>12.0e}")).concat();
    println!("{:<36}{cells}", "");
    rows("Van der Pol, ν = 5", &van_der_pol());
    rows("belt oscillator, arctan 1e3", &belt("arctan:1e3"));
    rows("belt oscillator, arctan 1e5", &belt("arctan:1e5"));
    rows("belt pair, arctan 1e5", &belt_pair());
    rows("drill string, quartic 1e-3", &drill_string());
}

fn rows<M: Model<N>, const N: usize>(title: &str, round: &Round<M, N>) {
    let truth = round.truth();
    println!("{title}");
    let ours = line("stickslip", &truth, |tolerance| {
        let derivatives = round.try_go(tolerance)?.derivatives?;
        Some((derivatives.state, derivatives.design))
    });
    let theirs = line("CVODES, staggered BDF", &truth, |tolerance| {
        cvodes::bdf(round, tolerance)
    });
    let ratio = |(ours, theirs): (Option<f64>, Option<f64>)| match (ours, theirs) {
        (Some(ours), Some(theirs)) => format!("{:>12.1}", theirs / ours),
        _ => format!("{:>12}", "-"),
    };
    let cells: String = ours.into_iter().zip(theirs).map(ratio).collect();
    println!("  {:<34}{cells}", "times ours");
}

/// The least times of all runs that are as accurate as wanted, in µs.
fn line<const N: usize>(
    name: &str,
    truth: &Sensitivities<N>,
    run: impl Fn(f64) -> Option<Sensitivities<N>>,
) -> [Option<f64>; 4] {
    let mut points = Vec::new();
    for half in 4..=26 {
        let tolerance = 10_f64.powf(-f64::from(half) / 2.0);
        if let Some(found) = run(tolerance) {
            let seconds = clock::best(Duration::from_millis(60), || {
                std::hint::black_box(run(std::hint::black_box(tolerance)));
            });
            points.push((errors(&found, truth).0, seconds * 1e6));
        }
    }
    let least = WANTED.map(|wanted| {
        let good = points.iter().filter(|(error, _)| *error <= wanted);
        good.map(|(_, time)| *time).min_by(f64::total_cmp)
    });
    let cells = least
        .map(|time| time.map_or_else(|| format!("{:>12}", "-"), |time| format!("{time:>12.0}")));
    println!("  {name:<34}{}", cells.concat());
    least
}

//! One period with Φ and ∂φ/∂r at ε = 1e5, at the tolerance at which Φ is good to 1e-7.

use std::time::Duration;

use stickslip::model::Model;

use crate::clock::best;
use crate::contender::{Contender, library, ours};
use crate::round::{Round, belt, belt_pair, errors};

/// Error of Φ, relative to its largest entry, at which flows are compared.
const PHI: f64 = 1e-7;

pub(crate) fn table() {
    println!("\nonce around at arctan:1e5 with Φ and ∂φ/∂r, at an error of Φ of at most {PHI:e}");
    println!(
        "{:<18}{:>10}{:>10}{:>8}{:>9}{:>7}{:>9}{:>10}{:>10}",
        "", "tolerance", "µs", "wanted", "steps", "rej.", "lin.", "err Φ", "err ∂r"
    );
    rows(&belt("arctan:1e5"), 150.0);
    rows(&belt_pair(), 600.0);
}

/// How the cost of a copy grows with the size of its smoothing: the layer is thinner by it, the steps are not.
pub(crate) fn growth() {
    println!(
        "\nonce around the belt oscillator at an error of Φ of at most {PHI:e}, by the size of the smoothing"
    );
    println!(
        "{:<18}{:>10}{:>10}{:>9}{:>7}{:>9}{:>10}",
        "", "tolerance", "µs", "steps", "rej.", "lin.", "err Φ"
    );
    for smoothing in [
        "arctan:1e1",
        "arctan:1e2",
        "arctan:1e3",
        "arctan:1e4",
        "arctan:1e5",
        "arctan:1e6",
        "arctan:1e7",
    ] {
        let round = belt(smoothing);
        let Some(fit) = Fit::of(&round, &ours()) else {
            println!("{smoothing:<18}does not reach an error of {PHI:e}");
            continue;
        };
        let work = round.go(fit.tolerance).work;
        println!(
            "{smoothing:<18}{:>10.1e}{:>10.1}{:>9}{:>7}{:>9}{:>10.1e}",
            fit.tolerance,
            fit.seconds * 1e6,
            work.steps,
            work.rejected,
            work.linearisations,
            fit.phi,
        );
    }
}

fn rows<M: Model<N>, const N: usize>(round: &Round<M, N>, wanted: f64) {
    let Some(fit) = Fit::of(round, &ours()) else {
        println!("{:<18}does not reach an error of {PHI:e}", M::INFO.command);
        return;
    };
    let work = round.go(fit.tolerance).work;
    println!(
        "{:<18}{:>10.1e}{:>10.1}{wanted:>8}{:>9}{:>7}{:>9}{:>10.1e}{:>10.1e}",
        M::INFO.command,
        fit.tolerance,
        fit.seconds * 1e6,
        work.steps,
        work.rejected,
        work.linearisations,
        fit.phi,
        fit.by_r,
    );
    let rivals = library();
    if rivals.is_empty() {
        println!(
            "{:<18}not measured: `cargo bench --features diffsol`",
            "  diffsol"
        );
    }
    for rival in &rivals {
        let name = format!("  {}", rival.name);
        match Fit::of(round, rival) {
            Some(theirs) => println!(
                "{name:<18}{:>10.1e}{:>10.1}{:>33}{:>10.1e}{:>10.1e}   {:.1} times ours (10 is wanted)",
                theirs.tolerance,
                theirs.seconds * 1e6,
                "",
                theirs.phi,
                theirs.by_r,
                theirs.seconds / fit.seconds,
            ),
            None => println!("{name:<18}does not reach an error of {PHI:e}"),
        }
    }
}

/// A contender at the loosest tolerance from which on every tighter one tried gives Φ to the error wanted.
struct Fit {
    tolerance: f64,
    phi: f64,
    by_r: f64,
    seconds: f64,
}

impl Fit {
    fn of<M: Model<N>, const N: usize>(
        round: &Round<M, N>,
        contender: &Contender<M, N>,
    ) -> Option<Self> {
        let truth = round.truth();
        let go = |tolerance: f64| Some(errors(&(contender.run)(round, tolerance)?, &truth));
        let tolerance = (12..=50)
            .rev()
            .map(|quarter| 10_f64.powf(-f64::from(quarter) / 4.0))
            .take_while(|&tolerance| go(tolerance).is_some_and(|(phi, _)| phi <= PHI))
            .last()?;
        let (phi, by_r) = go(tolerance)?;
        let seconds = best(Duration::from_secs(1), || {
            std::hint::black_box((contender.run)(round, std::hint::black_box(tolerance)));
        });
        Some(Self {
            tolerance,
            phi,
            by_r,
            seconds,
        })
    }
}

//! What one period of the exact flow costs, with its derivatives: `cargo run --release --example exact_cost`.

use std::time::Instant;

use stickslip::flow::exact::ExactFlow;
use stickslip::flow::{Flow, Want};
use stickslip::integrate::Tolerance;
use stickslip::model::{Model, ParamId};
use stickslip_models::{BeltOscillator, BeltPair, DrillString};

const REPEATS: usize = 400;

fn main() {
    let pair = [-0.5976, 0.0, -0.4604, -0.1607];
    for digits in [8, 10, 12] {
        println!("tolerance 1e-{digits}");
        cost(
            "belt oscillator",
            &BeltOscillator::default(),
            BeltOscillator::v_dr,
            [0.0, 0.2],
            12.001_031_294_830_579,
            digits,
        );
        cost(
            "belt pair",
            &BeltPair::default(),
            BeltPair::v_dr,
            pair,
            16.144_400_423_2,
            digits,
        );
        cost(
            "drill string",
            &DrillString::default(),
            DrillString::eta,
            [0.0, 4.0],
            6.530_582_884_2,
            digits,
        );
    }
}

/// Best time of many, with and without derivatives, and the error against a tighter run.
fn cost<M: Model<N>, const N: usize>(
    name: &str,
    model: &M,
    design: ParamId<M>,
    start: [f64; N],
    period: f64,
    digits: i32,
) {
    let run = |tolerance: f64, derivatives: bool| {
        let tolerance = Tolerance {
            relative: tolerance,
            absolute: tolerance,
        };
        let flow = ExactFlow::new(model, Some(design), tolerance).ok()?;
        let want = Want {
            derivatives,
            ..Want::default()
        };
        flow.advance(&flow.place(start).ok()?, period, want).ok()
    };
    for derivatives in [false, true] {
        let mut best = f64::INFINITY;
        let mut passage = None;
        for _ in 0..REPEATS {
            let clock = Instant::now();
            passage = run(0.1_f64.powi(digits), derivatives);
            best = best.min(clock.elapsed().as_secs_f64());
        }
        let (Some(passage), Some(truth)) = (passage, run(1e-14, derivatives)) else {
            println!("{name}: failed");
            continue;
        };
        let error = largest(passage.end.state.iter().zip(&truth.end.state));
        let slopes = |p: &stickslip::flow::Passage<N, _>| {
            let d = p.derivatives.clone();
            d.map_or(vec![], |d| {
                d.state
                    .into_iter()
                    .flatten()
                    .chain(d.design)
                    .collect::<Vec<_>>()
            })
        };
        let tangents = largest(slopes(&passage).iter().zip(&slopes(&truth)));
        println!(
            "{name:16} {:8.1} us  state {error:.1e}  slopes {tangents:.1e}  {:?}",
            best * 1e6,
            passage.work
        );
    }
}

fn largest<'a>(pairs: impl Iterator<Item = (&'a f64, &'a f64)>) -> f64 {
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

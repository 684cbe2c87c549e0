//! Chains of masses: f, the entries of the Jacobian and ∂f/∂r, generated over an index and written by hand.

use std::hint::black_box;
use std::time::Duration;

use stickslip::field::{Design, Field, SmoothField};
use stickslip::model::Model;
use stickslip_tests::chain::{Chain10, Chain20, Chain50, Chain100, by_hand};
use stickslip_tests::random::Random;

const STATES: usize = 32;
const ROUNDS: usize = 40;
const SIZE: f64 = 1e3;

pub(crate) fn table() {
    println!(
        "\nchains: f, entries of J and ∂f/∂r, ns per evaluation (at most 3 times the hand-written is wanted, and\n\
         the same for each mass); with J as a full matrix beside it"
    );
    println!(
        "{:<10}{:>11}{:>11}{:>8}{:>11}{:>13}",
        "masses", "generated", "by hand", "ratio", "per mass", "full matrix"
    );
    row::<Chain10, 20>();
    row::<Chain20, 40>();
    row::<Chain50, 100>();
    row::<Chain100, 200>();
}

fn row<M: Model<N>, const N: usize>() {
    let model = M::default();
    let smoothing = format!("arctan:{SIZE:e}").parse().ok();
    let field = SmoothField::new(&model, smoothing, Design::Parameter(1));
    let field = field.expect("a suitable smoothing");
    let mut random = Random::new(1);
    let states: Vec<[f64; N]> = (0..STATES).map(|_| random.array(|r| r.real(1.5))).collect();
    let parameters: [f64; 4] = std::array::from_fn(|p| model.values().as_ref()[p]);
    let (mut generated, mut written, mut full) = (f64::INFINITY, f64::INFINITY, f64::INFINITY);
    let mut entries = vec![0.0; 5 * N];
    let patience = Duration::from_millis(5);
    for _ in 0..ROUNDS {
        let seconds = super::clock::best(patience, || {
            for state in &states {
                let mut next = 0;
                let rates = black_box(&field).entries(black_box(state), |_, _, slope| {
                    entries[next] = slope;
                    next += 1;
                });
                black_box((rates, &entries));
            }
        });
        generated = generated.min(seconds);
        let seconds = super::clock::best(patience, || {
            for state in &states {
                let mut next = 0;
                let entry = |_, _, slope| {
                    entries[next] = slope;
                    next += 1;
                };
                let rates = by_hand(black_box(parameters), SIZE, black_box(state), entry);
                black_box((rates, &entries));
            }
        });
        written = written.min(seconds);
        let seconds = super::clock::best(patience, || {
            for state in &states {
                black_box(black_box(&field).linearise(black_box(state)));
            }
        });
        full = full.min(seconds);
    }
    let [generated, written, full] =
        [generated, written, full].map(|seconds| seconds / STATES as f64 * 1e9);
    println!(
        "{:<10}{generated:>11.1}{written:>11.1}{:>8.2}{:>11.2}{full:>13.1}",
        N / 2,
        generated / written,
        generated / (N / 2) as f64,
    );
}

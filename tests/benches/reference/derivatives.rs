//! f, its Jacobian and ∂f/∂r: generated, and written by hand as in the thesis's appendix B.

use std::hint::black_box;
use std::time::Duration;

use stickslip::field::{Design, Field, SmoothField, Smoothing};
use stickslip::model::Model;
use stickslip_models::{BeltOscillator, BeltPair, DrillString, VanDerPol};
use stickslip_tests::hand_written::{
    Linearised, belt_oscillator, belt_pair, drill_string, van_der_pol,
};
use stickslip_tests::random::Random;

const STATES: usize = 512;
const ROUNDS: usize = 40;

pub(crate) fn table() {
    println!("\nf, J and ∂f/∂r, ns per evaluation (at most 1.5 times the hand-written is wanted)");
    println!(
        "{:<18}{:>11}{:>11}{:>8}",
        "", "generated", "by hand", "ratio"
    );
    row::<VanDerPol, 2, 1>(VanDerPol::nu.index, None, van_der_pol);
    let belt = "arctan:1e5".parse().ok();
    let v_dr = BeltOscillator::v_dr.index;
    row::<BeltOscillator, 2, 5>(v_dr, belt, |p, x| belt_oscillator(p, 1e5, x));
    row::<BeltPair, 4, 4>(BeltPair::v_dr.index, belt, |p, x| belt_pair(p, 1e5, x));
    let bit = "quartic:1e-2".parse().ok();
    row::<DrillString, 2, 4>(DrillString::eta.index, bit, |p, x| drill_string(p, 1e-2, x));
}

fn row<M: Model<N>, const N: usize, const P: usize>(
    design: usize,
    smoothing: Option<Smoothing>,
    by_hand: impl Fn([f64; P], [f64; N]) -> Linearised<N, P>,
) {
    let model = M::default();
    let field = SmoothField::new(&model, smoothing, Design::Parameter(design));
    let field = field.expect("a suitable smoothing");
    let mut random = Random::new(1);
    let states: Vec<[f64; N]> = (0..STATES).map(|_| random.array(|r| r.real(1.5))).collect();
    let values = model.values();
    let parameters: [f64; P] = std::array::from_fn(|p| values.as_ref()[p]);
    let (mut generated, mut written) = (f64::INFINITY, f64::INFINITY);
    // Turn about, so that both meet the same disturbances.
    for _ in 0..ROUNDS {
        let patience = Duration::from_millis(5);
        let seconds = super::clock::best(patience, || {
            for state in &states {
                black_box(black_box(&field).linearise(black_box(state)));
            }
        });
        generated = generated.min(seconds);
        let seconds = super::clock::best(patience, || {
            for state in &states {
                let all = by_hand(black_box(parameters), *black_box(state));
                black_box((all.f, all.jacobian, all.by_parameter[design]));
            }
        });
        written = written.min(seconds);
    }
    let nanoseconds = |seconds: f64| seconds / STATES as f64 * 1e9;
    println!(
        "{:<18}{:>11.2}{:>11.2}{:>8.2}",
        M::INFO.command,
        nanoseconds(generated),
        nanoseconds(written),
        generated / written
    );
}

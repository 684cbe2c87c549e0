//! No step jumps a friction layer, however loose the tolerance: the right amplitude or an error, never a wrong one.

use stickslip::field::{Design, Kernel, SmoothField, Smoothing};
use stickslip::flow::exact::ExactFlow;
use stickslip::flow::{Flow, FlowError, SmoothFlow, Want};
use stickslip::integrate::Tolerance;
use stickslip::model::Model;
use stickslip_models::{BeltOscillator, BeltPair, DrillString};

const SIGNS: [Kernel; 5] = [
    Kernel::Arctan,
    Kernel::Tanh,
    Kernel::Algebraic,
    Kernel::Cubic,
    Kernel::Quintic,
];
const TOLERANCES: [f64; 7] = [1e-1, 3e-2, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6];

const EXTREMA: Want = Want::EXTREMA;

/// Largest |first state| once the motion from `start` has gone on for `before`, during the time `during`.
fn amplitude<F: Flow<N>, const N: usize>(
    flow: &F,
    start: [f64; N],
    (before, during): (f64, f64),
) -> Result<f64, FlowError> {
    let settled = flow.advance(&flow.place(start)?, before, Want::default())?;
    let watched = flow.advance(&settled.end, during, EXTREMA)?;
    let first = watched
        .extrema
        .iter()
        .filter(|extremum| extremum.index == 0);
    Ok(first
        .map(|extremum| extremum.state[0].abs())
        .fold(0.0, f64::max))
}

fn copy<M: Model<N>, const N: usize>(
    model: &M,
    smoothing: Smoothing,
    tolerance: f64,
) -> SmoothFlow<M, N> {
    let field =
        SmoothField::new(model, Some(smoothing), Design::None).expect("a suitable smoothing");
    let both = Tolerance {
        relative: tolerance,
        absolute: tolerance,
    };
    SmoothFlow::new(field, both)
}

/// Asks a model's copies at every tolerance; `true` amplitude, and how far off any answer may be.
fn never_wrong<M: Model<N>, const N: usize>(
    model: &M,
    smoothings: &[Smoothing],
    start: [f64; N],
    times: (f64, f64),
    (right, off): (f64, f64),
) {
    let mut answers = 0;
    for &smoothing in smoothings {
        for tolerance in TOLERANCES {
            match amplitude(&copy(model, smoothing, tolerance), start, times) {
                Ok(found) => {
                    answers += 1;
                    assert!(
                        (found / right - 1.0).abs() <= off,
                        "{} {smoothing} at {tolerance:e}: {found}, not {right}",
                        M::INFO.name
                    );
                }
                Err(error) => assert!(
                    tolerance >= 1e-4,
                    "{} {smoothing} at {tolerance:e}: {error}",
                    M::INFO.name
                ),
            }
        }
    }
    assert!(answers > 0, "no answer at all");
}

fn of(kernels: &[Kernel], size: f64) -> Vec<Smoothing> {
    kernels
        .iter()
        .map(|&kernel| Smoothing { kernel, size })
        .collect()
}

/// The case in which well-known codes answer 2.2, 2.7 or 8.0.
#[test]
fn one_mass_on_a_belt() {
    let belt = BeltOscillator::default();
    let times = (30.0, 60.0);
    let exact = ExactFlow::new(&belt, None, Tolerance::for_accuracy(1e-9)).expect("a flow");
    let right = amplitude(&exact, [1.3, 0.0], times).expect("a motion");
    assert!((right - 1.133_944_676).abs() < 1e-6, "{right}");
    never_wrong(&belt, &of(&SIGNS, 1e7), [1.3, 0.0], times, (right, 1e-2));
}

#[test]
#[ignore = "long"]
fn two_masses_on_a_belt() {
    let pair = BeltPair::default();
    let (start, times) = ([-0.5976, 0.0, -0.4604, -0.1607], (300.0, 100.0));
    let exact = ExactFlow::new(&pair, None, Tolerance::for_accuracy(1e-9)).expect("a flow");
    let right = amplitude(&exact, start, times).expect("a motion");
    never_wrong(&pair, &of(&SIGNS, 1e7), start, times, (right, 2e-2));
}

#[test]
fn drill_string() {
    let drill = DrillString::default();
    let (start, times) = ([6.0, 0.0], (30.0, 60.0));
    let exact = ExactFlow::new(&drill, None, Tolerance::for_accuracy(1e-9)).expect("a flow");
    let right = amplitude(&exact, start, times).expect("a motion");
    for size in [1e-2, 1e-4, 1e-6] {
        never_wrong(
            &drill,
            &of(&[Kernel::Quartic], size),
            start,
            times,
            (right, 3e-2),
        );
    }
}

//! What smoothing costs, and what it gets wrong: the belt oscillator with every smoothing beside the exact system.

mod needs;
mod precision;
mod predictions;

use stickslip::field::Kernel;
use stickslip::report::{Manuscript, Section};
use stickslip::study::parallel;
use stickslip::study::trade::{Scope, Trade};

use super::ReproduceError;
use super::ask::Subject;
use crate::BeltOscillator;

/// The belt speed of the comparison.
const SPEED: f64 = 0.2;
/// The accuracy for which the cheapest settings are sought.
const ACCURACY: f64 = 1e-3;
/// Smoothings of sgn that the belt oscillator's law accepts.
const KERNELS: [Kernel; 5] = [
    Kernel::Arctan,
    Kernel::Algebraic,
    Kernel::Tanh,
    Kernel::Cubic,
    Kernel::Quintic,
];

/// The section on the trade.
pub(super) fn section() -> Result<Section, ReproduceError> {
    let belt = Subject::new(BeltOscillator::v_dr);
    let trades: Vec<Vec<Trade>> = parallel(&KERNELS, |&kernel| measure(&belt, kernel))
        .into_iter()
        .collect::<Result<_, _>>()?;
    let trades = trades.concat();
    let manuscript = Manuscript::new(include_str!("smoothing.md"))
        .curves("A.1", [precision::curves(&trades)])
        .rows("needs", needs::rows(&trades))
        .rows("predictions", predictions::rows(&trades));
    Ok(manuscript.section()?)
}

/// The belt oscillator with one smoothing at all sizes and tolerances, and exact.
fn measure(belt: &Subject, kernel: Kernel) -> Result<Vec<Trade>, ReproduceError> {
    let scope = Scope {
        kernels: vec![kernel],
        accuracy: Some(ACCURACY),
        ..Scope::default()
    };
    belt.trade(SPEED, &scope)
}

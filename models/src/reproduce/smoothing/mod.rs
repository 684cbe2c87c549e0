//! What smoothing costs, and what it gets wrong: the belt oscillator with every smoothing beside the exact system.

mod needs;
mod precision;
mod predictions;

use stickslip::field::Kernel;
use stickslip::report::Section;
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
    Ok(Section::new("What smoothing costs, and what it gets wrong")
        .text(
            "Smoothing is a trade. A steeper copy is nearer to real friction, but harder to integrate, for its forces \
             change within ever thinner layers; and however small the steps, the computed motion only approaches that \
             of the copy. The exact system has no layer: while the mass sticks it moves with the belt, while it slips \
             the force is smooth, and the moments between are found as roots. All that is left is the error of \
             integration, which smaller steps make as small as one likes.",
        )
        .text(
            "Other shapes than the thesis's arctan can replace the jump: tanh, *z*/√(1 + *z*^{2}) (*algebraic*), and \
             polynomials that reach ±1 at finite *z* = *ε* *v*_{rel} and stay there (*cubic*, *quintic*). The slower a \
             shape approaches ±1, the more of the friction peak it loses, and arctan is the slowest.",
        )
        .figure(precision::figure(&trades))
        .table(needs::table(&trades))
        .text(
            "The error of a smoothing can also be told beforehand, from the exact orbit alone. A copy differs from it \
             in that it creeps where the mass should stick, and in that it lets go a little early, at the end of each \
             stick phase, where its layer loses its hold. Both are small disturbances of the exact orbit, whose \
             derivatives say what they do to period and extrema. No smooth motion is computed for the prediction.",
        )
        .table(predictions::table(&trades)))
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

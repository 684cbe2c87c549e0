//! Fig. 4.6: the equilibrium of the copy.

use stickslip::field::Kernel;
use stickslip::report::{Axis, Curve, Figure, Marker, Panel};

use super::super::ReproduceError;
use super::super::equilibrium::{piece, sign_change, trace};
use crate::DrillString;

const SIZE: f64 = 1.0;
const MOST: f64 = 5.0;

/// Twist at which the copy turns steadily: thesis (4.13).
fn rest(size: f64, eta: f64) -> f64 {
    let theta = DrillString::default().theta;
    let below = (eta - 4.0 * size).min(0.0);
    -theta / (27.0 * size.powi(4)) * eta * below.powi(3)
}

/// Table speeds between which the copy's equilibrium is unstable, the larger one first.
pub(super) fn hopf(size: f64) -> Result<[f64; 2], ReproduceError> {
    let at = |eta: f64| {
        let model = DrillString {
            eta,
            ..DrillString::default()
        };
        trace(&model, (Kernel::Quartic, size), [rest(size, eta), 0.0])
    };
    // The friction term rises most steeply at η = 2ε.
    let steepest = 2.0 * size;
    Ok([
        sign_change(at, 4.0 * size, steepest)?,
        sign_change(at, size, steepest)?,
    ])
}

pub(super) fn figure_6() -> Result<Figure, ReproduceError> {
    let at = |eta| rest(SIZE, eta);
    let [first, second] = hopf(SIZE)?;
    let panel = Panel::new(
        Axis::new("speed of the rotary table *η*").from(0.0, MOST),
        Axis::new("equilibrium *ψ*_{eq}").from(-0.5, 5.0),
    )
    .curve(piece(at, (0.0, second), true, "copy, stable"))
    .curve(piece(at, (first, MOST), true, "copy, stable"))
    .curve(piece(at, (second, first), false, "copy, unstable"))
    .curve(Curve::points(
        "Hopf points: artefacts of smoothing",
        2,
        Marker::Diamond,
        vec![[second, at(second)], [first, at(first)]],
    ))
    .curve(Curve::line(
        "exact, stable at every speed",
        3,
        vec![[0.0, 0.0], [MOST, 0.0]],
    ));
    Ok(Figure::new(
        "4.6",
        "Equilibrium of the copy *ε* = 1",
        format!(
            "Steady drilling, *ψ* = 0, is stable in the real system at every speed of the table. The copy lets friction \
             rise at speeds below 4*ε* already: its steady twist is off, and unstable between *η*_{{bif,2}} = {second:.4} \
             and *η*_{{bif,1}} = {first:.4} (thesis: 1.018 and 3.759). Both points are artefacts of smoothing."
        ),
    )
    .panel(panel))
}

//! Fig. 3.8: the equilibrium of the copy.

use stickslip::field::Kernel;
use stickslip::report::{Axis, Curve, Figure, Marker, Panel};

use super::super::ReproduceError;
use super::super::equilibrium::{piece, sign_change, trace};
use crate::BeltOscillator;

const SIZE: f64 = 1e2;
const MOST: f64 = 0.2;

/// Displacement at which the copy rests: thesis (3.9).
fn rest(size: f64, v_dr: f64) -> f64 {
    let BeltOscillator { k, F_s, delta, .. } = BeltOscillator::default();
    F_s / k * std::f64::consts::FRAC_2_PI * (size * v_dr).atan() / (1.0 + delta * v_dr)
}

/// Belt speed below which the copy's equilibrium is stable.
pub(super) fn hopf(size: f64) -> Result<f64, ReproduceError> {
    let logarithm = |log: f64| {
        let v_dr = log.exp();
        let model = BeltOscillator {
            v_dr,
            ..BeltOscillator::default()
        };
        trace(&model, (Kernel::Arctan, size), [rest(size, v_dr), 0.0])
    };
    Ok(sign_change(logarithm, (1e-3 / size).ln(), 0.0)?.exp())
}

pub(super) fn figure_8() -> Result<Figure, ReproduceError> {
    let at = |v_dr| rest(SIZE, v_dr);
    let v_bif = hopf(SIZE)?;
    let exact = (0..=200).map(|i| MOST * f64::from(i) / 200.0);
    let delta = BeltOscillator::default().delta;
    let exact = exact.map(|v| [v, 1.0 / (1.0 + delta * v)]).collect();
    let panel = Panel::new(
        Axis::new("belt speed *v*_{dr} (m/s)").from(0.0, MOST),
        Axis::new("equilibrium *x*_{eq} (m)").from(0.0, 1.0),
    )
    .curve(piece(at, (0.0, v_bif), true, "copy, stable"))
    .curve(piece(at, (v_bif, MOST), false, "copy, unstable"))
    .curve(Curve::points(
        "Hopf point: an artefact of smoothing",
        2,
        Marker::Diamond,
        vec![[v_bif, at(v_bif)]],
    ))
    .curve(Curve::line("exact, unstable at every speed", 3, exact));
    Ok(Figure::new(
        "3.8",
        "Equilibrium of the copy *ε* = 10^{2}",
        format!(
            "The mass can rest where the spring balances friction. At every speed of the belt this rest is unstable in \
             the real system, because friction weakens as the belt slides faster. Near zero speed the copy's friction \
             rises instead, as it leads through zero; there its rest is stable. The change at *v*_{{bif}} = {v_bif:.4} m/s \
             (thesis: 0.052) is an artefact of smoothing, and so is the copy's silence below it."
        ),
    )
    .panel(panel))
}

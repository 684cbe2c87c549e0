//! Points of a curve where a second condition is met: codimension two.

use nalgebra::Complex;

use super::condition::pairs;
use super::point::CurvePoint;
use crate::bifurcation::{Kind, test_function};

/// Which second condition.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Codimension {
    /// The quadratic coefficient of a fold vanishes: the curve turns back in both variables at once.
    Cusp,
    /// A multiplier 1 beside a multiplier −1.
    FoldFlip,
    /// Two multipliers 1.
    Resonance1,
    /// Two multipliers −1.
    Resonance2,
    /// A pair at a third of a turn.
    Resonance3,
    /// A pair at a quarter of a turn.
    Resonance4,
}

impl Codimension {
    /// All there are.
    pub const ALL: [Self; 6] = [
        Self::Cusp,
        Self::FoldFlip,
        Self::Resonance1,
        Self::Resonance2,
        Self::Resonance3,
        Self::Resonance4,
    ];

    /// The word for it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Cusp => "cusp",
            Self::FoldFlip => "fold-flip",
            Self::Resonance1 => "resonance-1-1",
            Self::Resonance2 => "resonance-1-2",
            Self::Resonance3 => "resonance-1-3",
            Self::Resonance4 => "resonance-1-4",
        }
    }

    /// The letters of its label: CP1, R2, ... are numbered.
    #[must_use]
    pub const fn letters(self) -> &'static str {
        match self {
            Self::Cusp => "CP",
            Self::FoldFlip => "LPPD",
            Self::Resonance1 => "R1-",
            Self::Resonance2 => "R2-",
            Self::Resonance3 => "R3-",
            Self::Resonance4 => "R4-",
        }
    }

    /// Whether it ends a curve of this kind: beyond a double multiplier ±1 a torus curve has a neutral saddle.
    #[must_use]
    pub fn ends(self, kind: Kind) -> bool {
        kind == Kind::Torus && matches!(self, Self::Resonance1 | Self::Resonance2)
    }

    /// A function that changes sign there along a curve of this kind; `None` if there is no such point on one.
    pub(super) fn test(self, kind: Kind, point: &CurvePoint) -> Option<f64> {
        let multipliers = &point.floquet().multipliers;
        match (kind, self) {
            (Kind::Fold, Self::Cusp) => Some(point.tangent[1]),
            (Kind::Fold, Self::FoldFlip) => Some(test_function::flip(multipliers)),
            (Kind::Flip, Self::FoldFlip) => Some(test_function::fold(multipliers)),
            (Kind::Fold, Self::Resonance1) => Some(test_function::fold(&without(multipliers, 1.0))),
            (Kind::Flip, Self::Resonance2) => {
                Some(test_function::flip(&without(multipliers, -1.0)))
            }
            (Kind::Torus, Self::Resonance1) => Some(1.0 - cosine(multipliers)?),
            (Kind::Torus, Self::Resonance2) => Some(1.0 + cosine(multipliers)?),
            (Kind::Torus, Self::Resonance3) => Some(0.5 + cosine(multipliers)?),
            (Kind::Torus, Self::Resonance4) => cosine(multipliers),
            _ => None,
        }
    }
}

/// All multipliers but the one nearest to `critical`.
fn without(multipliers: &[Complex<f64>], critical: f64) -> Vec<Complex<f64>> {
    let distance = |i: &usize| (multipliers[*i] - critical).norm();
    let nearest = (0..multipliers.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
    let others = (0..multipliers.len()).filter(|i| Some(*i) != nearest);
    others.map(|i| multipliers[i]).collect()
}

/// cos θ of the pair e^{±iθ}; beyond ±1 where that pair is real.
fn cosine(multipliers: &[Complex<f64>]) -> Option<f64> {
    let off = |(a, b): &(Complex<f64>, Complex<f64>)| (a * b - 1.0).norm();
    let pair = pairs(multipliers).min_by(|x, y| off(x).total_cmp(&off(y)));
    pair.map(|(a, b)| 0.5 * (a + b).re)
}

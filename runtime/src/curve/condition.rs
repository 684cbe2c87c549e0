//! The equation that an orbit of a curve keeps besides closing: a multiplier on the unit circle.

use nalgebra::{Complex, DMatrix, DVector, SVD};

use crate::bifurcation::{Kind, floquet, test_function};

/// A scalar that vanishes where an orbit is special of one kind, and passes through zero with a slope.
///
/// For a real multiplier it is the minimally augmented test of a singular matrix A: g from
/// [A b; cᵀ 0] [v; g] = [0; 1] (Govaerts 2000; Kuznetsov 2004, section 10.5). A is Φ + I for a flip,
/// and for a fold Φ − I with the direction of the motion, whose multiplier is always 1, moved away. For a
/// pair of complex ones it is the product of all μᵢμⱼ − 1.
#[derive(Debug, Clone, PartialEq)]
pub struct Condition {
    kind: Kind,
    /// b and c, near the null vectors of Aᵀ and A.
    border: Option<[DVector<f64>; 2]>,
}

impl Condition {
    /// The condition of a fold, flip or torus point; `None` for any other kind.
    #[must_use]
    pub fn of(kind: Kind) -> Option<Self> {
        let known = matches!(kind, Kind::Fold | Kind::Flip | Kind::Torus);
        known.then_some(Self { kind, border: None })
    }

    /// Which.
    #[must_use]
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// The condition for an orbit with this Φ and velocity at its start, states in units of `magnitude`.
    #[must_use]
    pub fn value(
        &self,
        monodromy: &DMatrix<f64>,
        velocity: &DVector<f64>,
        magnitude: &[f64],
    ) -> f64 {
        match (&self.border, self.kind) {
            (Some([b, c]), Kind::Fold | Kind::Flip) => {
                bordered(&self.matrix(monodromy, velocity, magnitude), b, c)
            }
            _ => {
                let verdict = floquet(monodromy, velocity, None, 0, &[], 0, 0.0);
                test_function::torus(&verdict.multipliers)
            }
        }
    }

    /// Takes the null vectors of A at an orbit as the new border.
    pub fn align(&mut self, monodromy: &DMatrix<f64>, velocity: &DVector<f64>, magnitude: &[f64]) {
        if self.kind == Kind::Torus {
            return;
        }
        let matrix = self.matrix(monodromy, velocity, magnitude);
        let decomposed = SVD::try_new(matrix, true, true, f64::EPSILON, 10_000);
        let Some((values, u, v)) = decomposed.and_then(|d| Some((d.singular_values, d.u?, d.v_t?)))
        else {
            return;
        };
        let least = values.argmin().0;
        let (b, c) = (u.column(least).into_owned(), v.row(least).transpose());
        // The sign of g must not jump from step to step.
        let turned = match &self.border {
            Some([_, old]) if old.dot(&c) < 0.0 => -1.0,
            _ => 1.0,
        };
        self.border = Some([b * turned, c * turned]);
    }

    /// A, in units of the magnitudes.
    fn matrix(
        &self,
        monodromy: &DMatrix<f64>,
        velocity: &DVector<f64>,
        magnitude: &[f64],
    ) -> DMatrix<f64> {
        let n = magnitude.len();
        let scaled = |i: usize, j: usize| monodromy[(i, j)] * magnitude[j] / magnitude[i];
        let phi = DMatrix::from_fn(n, n, scaled);
        if self.kind == Kind::Flip {
            return phi + DMatrix::identity(n, n);
        }
        let f = DVector::from_fn(n, |i, _| velocity[i] / magnitude[i]);
        let square = f.norm_squared();
        phi - DMatrix::identity(n, n) + &f * f.transpose() / square
    }

    /// How far the multipliers are from what the condition says, were it met.
    #[must_use]
    pub fn distance(&self, multipliers: &[Complex<f64>]) -> f64 {
        let nearest = |target: f64| {
            let distances = multipliers.iter().map(|mu| (mu - target).norm());
            distances.fold(f64::INFINITY, f64::min)
        };
        match self.kind {
            Kind::Fold => nearest(1.0),
            Kind::Flip => nearest(-1.0),
            _ => pairs(multipliers)
                .map(|(a, b)| (a * b - 1.0).norm())
                .fold(f64::INFINITY, f64::min),
        }
    }
}

/// Every two of the multipliers.
pub(super) fn pairs(
    multipliers: &[Complex<f64>],
) -> impl Iterator<Item = (Complex<f64>, Complex<f64>)> + '_ {
    let later = |i: usize| multipliers[i + 1..].iter();
    let all = multipliers.iter().enumerate();
    all.flat_map(move |(i, a)| later(i).map(move |b| (*a, *b)))
}

/// g of [A b; cᵀ 0] [v; g] = [0; 1]; NaN if the border does not make A regular.
fn bordered(matrix: &DMatrix<f64>, b: &DVector<f64>, c: &DVector<f64>) -> f64 {
    let n = matrix.nrows();
    let whole = DMatrix::from_fn(n + 1, n + 1, |i, j| match (i == n, j == n) {
        (false, false) => matrix[(i, j)],
        (false, true) => b[i],
        (true, false) => c[j],
        (true, true) => 0.0,
    });
    let mut right = DVector::zeros(n + 1);
    right[n] = 1.0;
    whole.lu().solve(&right).map_or(f64::NAN, |all| all[n])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Multipliers 1, ν and 0.2.
    fn phi(nu: f64) -> DMatrix<f64> {
        DMatrix::from_row_slice(3, 3, &[1.0, 0.3, 0.1, 0.0, nu, 0.7, 0.0, 0.0, 0.2])
    }

    /// e₁.
    fn velocity() -> DVector<f64> {
        DVector::from_vec(vec![1.0, 0.0, 0.0])
    }

    fn value(condition: &Condition, nu: f64) -> f64 {
        condition.value(&phi(nu), &velocity(), &[1.0, 2.0, 0.5])
    }

    #[test]
    fn it_passes_through_zero_with_a_slope() {
        for (kind, critical) in [(Kind::Fold, 1.0), (Kind::Flip, -1.0)] {
            let mut condition = Condition::of(kind).unwrap();
            condition.align(&phi(critical + 0.01), &velocity(), &[1.0, 2.0, 0.5]);
            assert!(value(&condition, critical).abs() < 1e-14);
            let slope =
                (value(&condition, critical + 1e-4) - value(&condition, critical - 1e-4)) / 2e-4;
            assert!(slope.abs() > 0.1 && slope.abs() < 10.0, "{kind:?}: {slope}");
        }
    }

    #[test]
    fn a_sliding_bifurcation_has_no_multiplier() {
        assert_eq!(Condition::of(Kind::GrazingSliding), None);
        let torus = Condition::of(Kind::Torus).unwrap();
        let pair = Complex::from_polar(1.0, 0.7);
        assert!(torus.distance(&[pair, pair.conj(), Complex::new(0.2, 0.0)]) < 1e-15);
    }
}

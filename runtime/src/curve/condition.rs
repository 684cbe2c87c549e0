//! The equation that an orbit or an equilibrium of a curve keeps besides its own: a multiplier on the unit circle, an
//! eigenvalue on the imaginary axis.

use nalgebra::{Complex, DMatrix, DVector};

use super::subject::Beside;
use crate::bifurcation::{Kind, floquet, test_function};
use crate::linear::{eigenvalues, svd};

/// A scalar that vanishes where an orbit or an equilibrium is special of one kind, and passes through zero with a slope.
///
/// For a real multiplier or eigenvalue it is the minimally augmented test of a singular matrix A: g from
/// [A b; cᵀ 0] [v; g] = [0; 1] (Govaerts 2000; Kuznetsov 2004, section 10.5). A is Φ + I for a flip,
/// and for a fold Φ − I with the direction of the motion, whose multiplier is always 1, moved away; for a fold of
/// equilibria it is the Jacobian. For a pair of complex multipliers it is the product of all μᵢμⱼ − 1; for a pair of
/// eigenvalues its sum, which is smooth where the pair meets and becomes real.
#[derive(Debug, Clone, PartialEq)]
pub struct Condition {
    kind: Kind,
    near: Near,
}

/// What the last orbit or equilibrium has shown.
#[derive(Debug, Clone, PartialEq)]
enum Near {
    Nothing,
    /// b and c, near the null vectors of Aᵀ and A.
    Border([DVector<f64>; 2]),
    /// The product of the two eigenvalues, and that of the first ones.
    Pair {
        product: f64,
        first: f64,
    },
}

impl Condition {
    /// The condition of orbits at a fold, flip or torus point; `None` for any other kind.
    #[must_use]
    pub fn of_orbits(kind: Kind) -> Option<Self> {
        matches!(kind, Kind::Fold | Kind::Flip | Kind::Torus).then_some(Self::unaligned(kind))
    }

    /// The condition of equilibria at a fold or Hopf point; `None` for any other kind.
    #[must_use]
    pub fn of_equilibria(kind: Kind) -> Option<Self> {
        matches!(kind, Kind::Fold | Kind::Hopf).then_some(Self::unaligned(kind))
    }

    const fn unaligned(kind: Kind) -> Self {
        let near = Near::Nothing;
        Self { kind, near }
    }

    /// Which.
    #[must_use]
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// The condition where motions come nearer or leave like this, states in units of `magnitude`.
    #[must_use]
    pub fn value(&self, beside: &Beside, magnitude: &[f64]) -> f64 {
        match (&self.near, beside) {
            (Near::Border([b, c]), _) => bordered(&self.matrix(beside, magnitude), b, c),
            (Near::Pair { product, first }, Beside::Equilibrium(jacobian)) => {
                let sum = self.pair(jacobian, Some(*product)).map(|[a, b]| (a + b).re);
                sum.map_or(f64::NAN, |sum| sum / first.sqrt())
            }
            (_, Beside::Orbit(phi, velocity)) => {
                let verdict = floquet(phi, velocity, None, 0, &[], 0, 0.0);
                test_function::torus(&verdict.multipliers)
            }
            (_, Beside::Equilibrium(_)) => f64::NAN,
        }
    }

    /// Takes what an orbit or an equilibrium shows for what is near.
    pub fn align(&mut self, beside: &Beside, magnitude: &[f64]) {
        let near = match (self.kind, beside) {
            (Kind::Fold | Kind::Flip, _) => self.border(self.matrix(beside, magnitude)),
            (Kind::Hopf, Beside::Equilibrium(jacobian)) => self.paired(jacobian),
            _ => None,
        };
        self.near = near.unwrap_or_else(|| self.near.clone());
    }

    /// The null vectors of A.
    fn border(&self, matrix: DMatrix<f64>) -> Option<Near> {
        let all = svd(matrix)?;
        let (values, u, v) = (all.singular_values, all.u?, all.v_t?);
        let least = values.argmin().0;
        let (b, c) = (u.column(least).into_owned(), v.row(least).transpose());
        // The sign of g must not jump from step to step.
        let turned = match &self.near {
            Near::Border([_, old]) if old.dot(&c) < 0.0 => -1.0,
            _ => 1.0,
        };
        Some(Near::Border([b * turned, c * turned]))
    }

    /// The product of the pair that is followed.
    fn paired(&self, jacobian: &DMatrix<f64>) -> Option<Near> {
        let known = match self.near {
            Near::Pair { product, first } => Some((product, first)),
            _ => None,
        };
        let [a, b] = self.pair(jacobian, known.map(|(product, _)| product))?;
        let product = (a * b).re;
        let first = known.map_or(product.abs(), |(_, first)| first);
        Some(Near::Pair { product, first })
    }

    /// The pair of eigenvalues that is followed, of a Hopf point.
    #[must_use]
    pub fn followed(&self, jacobian: &DMatrix<f64>) -> Option<[Complex<f64>; 2]> {
        match self.near {
            Near::Pair { product, .. } => self.pair(jacobian, Some(product)),
            _ => None,
        }
    }

    /// The two eigenvalues that are nearest to a sum of 0 with this product; with none, the complex ones nearest to the
    /// imaginary axis, beside what they turn.
    fn pair(&self, jacobian: &DMatrix<f64>, product: Option<f64>) -> Option<[Complex<f64>; 2]> {
        let all: Vec<Complex<f64>> = eigenvalues(jacobian).iter().map(|one| one.value).collect();
        let real = |(a, b): &(Complex<f64>, Complex<f64>)| a.im == -b.im;
        let off = |(a, b): &(Complex<f64>, Complex<f64>)| match product {
            Some(product) => (a + b).norm_sqr() + (a * b - product).norm(),
            None if a.im == 0.0 => f64::INFINITY,
            None => (a + b).norm() / a.norm(),
        };
        let nearest = pairs(&all)
            .filter(real)
            .min_by(|x, y| off(x).total_cmp(&off(y)))?;
        off(&nearest).is_finite().then_some([nearest.0, nearest.1])
    }

    /// A, in units of the magnitudes.
    fn matrix(&self, beside: &Beside, magnitude: &[f64]) -> DMatrix<f64> {
        let n = magnitude.len();
        let scaled = |matrix: &DMatrix<f64>| {
            DMatrix::from_fn(n, n, |i, j| matrix[(i, j)] * magnitude[j] / magnitude[i])
        };
        match beside {
            Beside::Equilibrium(jacobian) => {
                let jacobian = scaled(jacobian);
                let size = jacobian.norm();
                jacobian / size
            }
            Beside::Orbit(phi, _) if self.kind == Kind::Flip => {
                scaled(phi) + DMatrix::identity(n, n)
            }
            Beside::Orbit(phi, velocity) => {
                let f = DVector::from_fn(n, |i, _| velocity[i] / magnitude[i]);
                let square = f.norm_squared();
                scaled(phi) - DMatrix::identity(n, n) + &f * f.transpose() / square
            }
        }
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
        condition.value(&Beside::Orbit(phi(nu), velocity()), &[1.0, 2.0, 0.5])
    }

    #[test]
    fn it_passes_through_zero_with_a_slope() {
        for (kind, critical) in [(Kind::Fold, 1.0), (Kind::Flip, -1.0)] {
            let mut condition = Condition::of_orbits(kind).unwrap();
            let beside = Beside::Orbit(phi(critical + 0.01), velocity());
            condition.align(&beside, &[1.0, 2.0, 0.5]);
            assert!(value(&condition, critical).abs() < 1e-14);
            let slope =
                (value(&condition, critical + 1e-4) - value(&condition, critical - 1e-4)) / 2e-4;
            assert!(slope.abs() > 0.1 && slope.abs() < 10.0, "{kind:?}: {slope}");
        }
    }

    #[test]
    fn a_sliding_bifurcation_has_no_multiplier() {
        assert_eq!(Condition::of_orbits(Kind::GrazingSliding), None);
        let torus = Condition::of_orbits(Kind::Torus).unwrap();
        let pair = Complex::from_polar(1.0, 0.7);
        assert!(torus.distance(&[pair, pair.conj(), Complex::new(0.2, 0.0)]) < 1e-15);
    }

    /// A pair ρ ± iω beside −0.2.
    fn jacobian(rate: f64, square: f64) -> Beside {
        let rows = [rate, 1.0, 0.3, -square, rate, 0.4, 0.0, 0.0, -0.2];
        Beside::Equilibrium(DMatrix::from_row_slice(3, 3, &rows))
    }

    #[test]
    fn the_sum_of_a_pair_is_smooth_where_it_becomes_real() {
        assert_eq!(Condition::of_orbits(Kind::Hopf), None);
        let mut condition = Condition::of_equilibria(Kind::Hopf).unwrap();
        condition.align(&jacobian(0.0, 0.09), &[1.0; 3]);
        for square in [0.04, 1e-4, -1e-4, -0.01] {
            condition.align(&jacobian(0.0, square), &[1.0; 3]);
            for rate in [-1e-3, 0.0, 1e-3] {
                let value = condition.value(&jacobian(rate, square), &[1.0; 3]);
                let expected = 2.0 * rate / 0.3;
                assert!((value - expected).abs() < 1e-14, "{square}: {value}");
            }
        }
    }
}

//! How periodic motions begin at a Hopf point: softly, beside the stable side of the equilibrium, or hard.

use nalgebra::{Complex, DMatrix, DVector};

use crate::linear::svd;
use crate::motion::{Flow, Place};

/// The longest step of the differences of exact Jacobians, as a share of the largest state; each next one is so much shorter.
const STEP: f64 = 1e-2;
const SHORTER: f64 = 0.5;
/// By how many times what the eigenvalues lack to ±iω, relative to ω, the terms of the coefficient may be off.
const BESIDE: f64 = 10.0;
/// How many steps are tried: the best is the one that differs least from the two before.
const STEPS: i32 = 30;

type Vector = DVector<Complex<f64>>;

/// The first Lyapunov coefficient of a Hopf point: with an eigenvector of length 1, the amplitude of small motions along it
/// grows like ω l₁ times its third power where the linear rate is zero (Kuznetsov 2004, equation 5.39).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Onset {
    /// l₁.
    pub coefficient: f64,
    /// Its estimated error.
    pub error: f64,
}

impl Onset {
    /// `soft` where small stable motions grow from nothing, `hard` where small unstable ones bound what the equilibrium
    /// draws in; `None` where the coefficient is zero as far as it is known.
    #[must_use]
    pub fn name(&self) -> Option<&'static str> {
        let known = self.coefficient.abs() > self.error;
        known.then_some(if self.coefficient < 0.0 {
            "soft"
        } else {
            "hard"
        })
    }

    /// The onset at a place where the Jacobian has the eigenvalues ±iω; `None` where it is not known.
    #[must_use]
    pub fn of(flow: &dyn Flow, place: &Place, frequency: f64) -> Option<Self> {
        let pair = Pair::of(flow, place, frequency)?;
        let largest = place
            .state
            .iter()
            .fold(0.0_f64, |most, y| most.max(y.abs()));
        let size = if largest > 0.0 { largest } else { 1.0 };
        let mut best: Option<Self> = None;
        let (mut before, mut corrected, mut apart) = (None::<f64>, f64::INFINITY, f64::INFINITY);
        for k in 0..STEPS {
            let step = size * STEP * SHORTER.powi(k);
            let Some([value, terms]) = pair.coefficient(step) else {
                before = None;
                continue;
            };
            if let Some(long) = before {
                // The error of central differences falls with the square of the step.
                let coefficient = value + (value - long) / (SHORTER.powi(-2) - 1.0);
                let moved = (coefficient - corrected).abs();
                // Two values may agree by chance, three hardly.
                let error =
                    moved.max(apart) + pair.rounding(step) + BESIDE * pair.off / frequency * terms;
                if best.map_or(error.is_finite(), |best| error < best.error) {
                    best = Some(Self { coefficient, error });
                }
                (corrected, apart) = (coefficient, moved);
            }
            before = Some(value);
        }
        best
    }
}

/// The critical eigenvectors at a place.
struct Pair<'a> {
    flow: &'a dyn Flow,
    place: &'a Place,
    jacobian: DMatrix<f64>,
    frequency: f64,
    /// Real and imaginary part of the right one.
    q: [DVector<f64>; 2],
    /// The left one, conjugate, over its product with the right one.
    left: Vector,
    /// The least change of the Jacobian that gives it the eigenvalues ±iω.
    off: f64,
}

/// First and second differences of the Jacobian along a direction.
struct Differences {
    first: DMatrix<f64>,
    second: DMatrix<f64>,
}

impl<'a> Pair<'a> {
    fn of(flow: &'a dyn Flow, place: &'a Place, frequency: f64) -> Option<Self> {
        let jacobian = flow.velocity(place).ok()?.jacobian;
        let n = jacobian.nrows();
        // (A − iω)(a + ib) = 0 in real and imaginary parts; on the left its transpose.
        let mut whole = DMatrix::zeros(2 * n, 2 * n);
        whole.view_mut((0, 0), (n, n)).copy_from(&jacobian);
        whole.view_mut((n, n), (n, n)).copy_from(&jacobian);
        for i in 0..n {
            whole[(i, n + i)] = frequency;
            whole[(n + i, i)] = -frequency;
        }
        let all = svd(whole)?;
        let least = all.singular_values.argmin().0;
        let (right, left) = (
            all.v_t?.row(least).transpose(),
            all.u?.column(least).into_owned(),
        );
        let q = [0, n].map(|from| right.rows(from, n).into_owned());
        let conjugate = Vector::from_fn(n, |i, _| Complex::new(left[i], -left[n + i]));
        let product = conjugate.dot(&joined(&q[0], &q[1]));
        (product.norm() > 0.0).then(|| Self {
            flow,
            place,
            jacobian,
            frequency,
            q,
            left: conjugate / product,
            off: all.singular_values[least],
        })
    }

    fn at(&self, along: &DVector<f64>, step: f64) -> Option<DMatrix<f64>> {
        let moved = self.place.state.iter().zip(along);
        let place = Place {
            state: moved.map(|(y, way)| y + step * way).collect(),
            modes: self.place.modes.clone(),
        };
        Some(self.flow.velocity(&place).ok()?.jacobian)
    }

    /// What rounding leaves uncertain of the coefficient: second differences lose most.
    fn rounding(&self, step: f64) -> f64 {
        let lost = 4.0 * f64::EPSILON * self.jacobian.amax() / (step * step);
        lost * self.left.norm() / (2.0 * self.frequency)
    }

    fn differences(&self, along: &DVector<f64>, step: f64) -> Option<Differences> {
        let (low, high) = (self.at(along, -step)?, self.at(along, step)?);
        Some(Differences {
            first: (&high - &low) / (2.0 * step),
            second: (high - &self.jacobian * 2.0 + low) / (step * step),
        })
    }

    /// l₁ from the multilinear forms B and C of second and third derivatives, by differences over a step; and how large its
    /// terms are together.
    fn coefficient(&self, step: f64) -> Option<[f64; 2]> {
        let [a, b] = &self.q;
        let (along_a, along_b) = (self.differences(a, step)?, self.differences(b, step)?);
        let (da, db) = (&along_a.first, &along_b.first);
        // C(q, q, q̄), B(q, q̄) and B(q, q) for q = a + ib.
        let third = along_a.second + along_b.second;
        let third = joined(&(&third * a), &(&third * b));
        let mixed = da * a + db * b;
        let square = joined(&(da * a - db * b), &(da * b * 2.0));
        let steady = self.jacobian.clone().lu().solve(&mixed)?;
        let twice = Complex::new(0.0, 2.0 * self.frequency);
        let n = a.len();
        let matrix = DMatrix::from_fn(n, n, |i, j| {
            let diagonal = if i == j { twice } else { Complex::default() };
            diagonal - self.jacobian[(i, j)]
        });
        let double = matrix.lu().solve(&square)?;
        let shifted = joined(&(da * &steady), &(db * &steady));
        let (re, im) = (double.map(|one| one.re), double.map(|one| one.im));
        // B(q̄, h) for h = re + i im.
        let back = joined(&(da * &re + db * &im), &(da * &im - db * &re));
        let shifted = shifted * Complex::new(-2.0, 0.0);
        let terms =
            [third, shifted, back].map(|term| self.left.dot(&term) / (2.0 * self.frequency));
        let value: f64 = terms.iter().map(|term| term.re).sum();
        let size = terms.iter().map(|term| term.norm()).sum();
        value.is_finite().then_some([value, size])
    }
}

fn joined(re: &DVector<f64>, im: &DVector<f64>) -> Vector {
    re.zip_map(im, Complex::new)
}

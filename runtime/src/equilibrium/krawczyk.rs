//! Equilibria proven by Krawczyk's operator with intervals: a box that holds one, and only one.

use nalgebra::DMatrix;

use super::newton::near;
use crate::field::{Enclosed, EnclosedField, Unenclosed};
use crate::math::interval::Interval;
use crate::model::Model;

/// The first box, over the correction that Newton would make.
const WIDER: f64 = 2.0;
/// Rounding errors of the states that the first box takes in anyway.
const ROUNDING: f64 = 8.0;
/// Boxes tried, each twice what the one before was mapped to.
const BOXES: usize = 24;

/// A box that holds exactly one equilibrium: rigorous, but for what [`interval`](crate::math::interval) assumes.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "app", derive(serde::Serialize))]
pub struct Proof {
    /// Smallest value of each state.
    #[cfg_attr(feature = "app", serde(rename = "min"))]
    pub low: Vec<f64>,
    /// Largest value of each state.
    #[cfg_attr(feature = "app", serde(rename = "max"))]
    pub high: Vec<f64>,
}

/// Why an equilibrium is not proven.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Unproven {
    /// The field cannot be enclosed around it.
    #[error(transparent)]
    Field(#[from] Unenclosed),
    /// The Jacobian has no inverse: equilibria may form a set, or two of them meet.
    #[error("the Jacobian there is singular as far as numbers can tell")]
    Singular,
    /// There is one, but not where it was said to be.
    #[error("there is none: the nearest that is proven lies at {state:?}")]
    Elsewhere {
        /// A state in the proven box.
        state: Vec<f64>,
    },
    /// No box is mapped into itself.
    #[error(
        "no box around it is mapped into itself: its image reaches {reach:.1} times as far, with C an inverse of the \
         Jacobian J, |1 − CJ| is {contraction:.1e} over it, and Newton's step {step:.1e}, for a half width {width:.1e}"
    )]
    NotContracting {
        /// How far the image of the last box reaches, over how far the box itself does; 1 is too far.
        reach: f64,
        /// |1 − CJ| over that box.
        contraction: f64,
        /// Newton's step from the middle.
        step: f64,
        /// Largest half width of that box.
        width: f64,
    },
}

/// Proves that `state` is an equilibrium of `field`, but for rounding errors, and that no other is next to it.
///
/// With C near J(y)⁻¹, K(Y) = y − C f(y) + (1 − C J(Y)) (Y − y): where K(Y) lies inside the box Y, f has exactly one
/// zero in Y, and it lies in K(Y) (Krawczyk 1969). J may hold the slopes of both sides of a kink.
///
/// # Errors
/// See [`Unproven`]: that says nothing about whether there is one.
pub fn prove<M: Model<N>, const N: usize>(
    field: &EnclosedField<M, N>,
    state: &[f64; N],
) -> Result<Proof, Unproven> {
    let here = field.over(&state.map(Interval::from))?;
    let slopes = DMatrix::from_fn(N, N, |i, j| here.jacobian[i][j].middle());
    let inverse = slopes.try_inverse().ok_or(Unproven::Singular)?;
    if !inverse.iter().all(|entry| entry.is_finite()) {
        return Err(Unproven::Singular);
    }
    let newton: [Interval; N] =
        std::array::from_fn(|i| -dot(N, |k| Interval::from(inverse[(i, k)]) * here.f[k]));
    let operator = Operator {
        state,
        inverse,
        newton,
    };
    operator.prove(field)
}

/// Krawczyk's operator around a state.
struct Operator<'a, const N: usize> {
    state: &'a [f64; N],
    inverse: DMatrix<f64>,
    /// −C f(y).
    newton: [Interval; N],
}

impl<const N: usize> Operator<'_, N> {
    fn prove<M: Model<N>>(&self, field: &EnclosedField<M, N>) -> Result<Proof, Unproven> {
        let rounding = self.state.map(|y| ROUNDING * f64::EPSILON * y.abs());
        let mut reach: [f64; N] = std::array::from_fn(|i| {
            WIDER * self.newton[i].magnitude() + rounding[i] + f64::MIN_POSITIVE
        });
        let mut last = None;
        for _ in 0..BOXES {
            if !reach.iter().all(|reach| reach.is_finite()) {
                break;
            }
            let ball = reach.map(|reach| Interval::around(0.0, reach));
            let over: [Interval; N] =
                std::array::from_fn(|j| Interval::from(self.state[j]) + ball[j]);
            // A box that was mapped too far and now meets a kink that it did not meet before is too large.
            let field = match (field.over(&over), last) {
                (Ok(field), _) => field,
                (Err(_), Some(failed)) => return Err(failed),
                (Err(error), None) => return Err(error.into()),
            };
            let rest = self.rest(&field);
            let image: [Interval; N] =
                std::array::from_fn(|i| self.newton[i] + dot(N, |j| rest[i][j] * ball[j]));
            if (0..N).all(|i| image[i].is_inside(ball[i])) {
                let image: [Interval; N] =
                    std::array::from_fn(|i| Interval::from(self.state[i]) + image[i]);
                return self.verdict(image);
            }
            last = Some(self.failed(&reach, &image, &rest));
            for (reach, image) in reach.iter_mut().zip(&image) {
                *reach = WIDER * reach.max(image.magnitude());
            }
        }
        Err(last.unwrap_or(Unproven::Singular))
    }

    /// The proven box, if it is one of the equilibrium that was meant.
    fn verdict(&self, image: [Interval; N]) -> Result<Proof, Unproven> {
        let proven = image.map(Interval::middle);
        if !near(&proven, self.state) {
            let state = proven.to_vec();
            return Err(Unproven::Elsewhere { state });
        }
        Ok(Proof {
            low: image.map(Interval::low).to_vec(),
            high: image.map(Interval::high).to_vec(),
        })
    }

    /// 1 − C J(Y).
    fn rest(&self, field: &Enclosed<N>) -> [[Interval; N]; N] {
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let product = dot(N, |k| {
                    Interval::from(self.inverse[(i, k)]) * field.jacobian[k][j]
                });
                Interval::from(f64::from(i == j)) - product
            })
        })
    }

    fn failed(
        &self,
        reach: &[f64; N],
        image: &[Interval; N],
        rest: &[[Interval; N]; N],
    ) -> Unproven {
        let most = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
        let rows = rest
            .iter()
            .map(|row| row.iter().map(|entry| entry.magnitude()).sum());
        Unproven::NotContracting {
            reach: most(&mut (0..N).map(|i| image[i].magnitude() / reach[i])),
            contraction: most(&mut rows.into_iter()),
            step: most(&mut self.newton.iter().map(|step| step.magnitude())),
            width: most(&mut reach.iter().copied()),
        }
    }
}

fn dot(terms: usize, term: impl Fn(usize) -> Interval) -> Interval {
    (0..terms).fold(Interval::ZERO, |sum, k| sum + term(k))
}

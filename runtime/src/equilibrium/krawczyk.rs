//! Equilibria proven by Krawczyk's operator with intervals: a box that holds one, and only one.

use nalgebra::DMatrix;
use serde::Serialize;

use super::newton::near;
use crate::field::Unenclosed;
use crate::math::interval::Interval;
use crate::model::Values;
use crate::motion::{Enclosed, Enclosure};

/// The first box, over the correction that Newton would make.
const WIDER: f64 = 2.0;
/// Rounding errors of the states that the first box takes in anyway.
const ROUNDING: f64 = 8.0;
/// Boxes tried, each twice what the one before was mapped to.
const BOXES: usize = 24;

/// A box that holds exactly one equilibrium: rigorous, but for what [`interval`](crate::math::interval) assumes.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Proof {
    /// Smallest value of each state.
    #[serde(rename = "min")]
    pub low: Vec<f64>,
    /// Largest value of each state.
    #[serde(rename = "max")]
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
    #[error("there is none: the nearest that is proven lies at {state}")]
    Elsewhere {
        /// A state in the proven box.
        state: Values,
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
pub fn prove(field: &dyn Enclosure, state: &[f64]) -> Result<Proof, Unproven> {
    let order = field.order();
    let state: Vec<f64> = (0..order)
        .map(|j| state.get(j).copied().unwrap_or(f64::NAN))
        .collect();
    let point: Vec<Interval> = state.iter().map(|y| Interval::from(*y)).collect();
    let here = field.over(&point)?;
    let slopes = DMatrix::from_fn(order, order, |i, j| here.jacobian[i][j].middle());
    let inverse = slopes.try_inverse().ok_or(Unproven::Singular)?;
    if !inverse.iter().all(|entry| entry.is_finite()) {
        return Err(Unproven::Singular);
    }
    let newton = (0..order)
        .map(|i| -dot(order, |k| Interval::from(inverse[(i, k)]) * here.f[k]))
        .collect();
    let operator = Operator {
        state,
        inverse,
        newton,
    };
    operator.prove(field)
}

/// Krawczyk's operator around a state.
struct Operator {
    state: Vec<f64>,
    inverse: DMatrix<f64>,
    /// −C f(y).
    newton: Vec<Interval>,
}

impl Operator {
    fn prove(&self, field: &dyn Enclosure) -> Result<Proof, Unproven> {
        let order = self.state.len();
        let first = |(y, step): (&f64, &Interval)| {
            let rounding = ROUNDING * f64::EPSILON * y.abs();
            WIDER * step.magnitude() + rounding + f64::MIN_POSITIVE
        };
        let mut reach: Vec<f64> = self.state.iter().zip(&self.newton).map(first).collect();
        let mut last = None;
        for _ in 0..BOXES {
            if !reach.iter().all(|reach| reach.is_finite()) {
                break;
            }
            let ball: Vec<Interval> = reach.iter().map(|y| Interval::around(0.0, *y)).collect();
            // A box that was mapped too far and now meets a kink that it did not meet before is too large.
            let field = match (field.over(&self.around(&ball)), last) {
                (Ok(field), _) => field,
                (Err(_), Some(failed)) => return Err(failed),
                (Err(error), None) => return Err(error.into()),
            };
            let rest = self.rest(&field);
            let image: Vec<Interval> = (0..order)
                .map(|i| self.newton[i] + dot(order, |j| rest[i][j] * ball[j]))
                .collect();
            if image
                .iter()
                .zip(&ball)
                .all(|(image, ball)| image.is_inside(*ball))
            {
                return self.verdict(&self.around(&image));
            }
            last = Some(self.failed(&reach, &image, &rest));
            for (reach, image) in reach.iter_mut().zip(&image) {
                *reach = WIDER * reach.max(image.magnitude());
            }
        }
        Err(last.unwrap_or(Unproven::Singular))
    }

    /// The state, moved by these.
    fn around(&self, moves: &[Interval]) -> Vec<Interval> {
        let moved = |(y, by): (&f64, &Interval)| Interval::from(*y) + *by;
        self.state.iter().zip(moves).map(moved).collect()
    }

    /// The proven box, if it is one of the equilibrium that was meant.
    fn verdict(&self, image: &[Interval]) -> Result<Proof, Unproven> {
        let each = |read: fn(Interval) -> f64| image.iter().map(|y| read(*y)).collect();
        let state: Vec<f64> = each(Interval::middle);
        if !near(&state, &self.state, &vec![1.0; state.len()]) {
            return Err(Unproven::Elsewhere {
                state: state.into(),
            });
        }
        Ok(Proof {
            low: each(Interval::low),
            high: each(Interval::high),
        })
    }

    /// 1 − C J(Y).
    fn rest(&self, field: &Enclosed) -> Vec<Vec<Interval>> {
        let order = self.state.len();
        let entry = |i: usize, j: usize| {
            let product = dot(order, |k| {
                Interval::from(self.inverse[(i, k)]) * field.jacobian[k][j]
            });
            Interval::from(f64::from(i == j)) - product
        };
        (0..order)
            .map(|i| (0..order).map(|j| entry(i, j)).collect())
            .collect()
    }

    fn failed(&self, reach: &[f64], image: &[Interval], rest: &[Vec<Interval>]) -> Unproven {
        let most = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
        let sum = |row: &Vec<Interval>| row.iter().map(|entry| entry.magnitude()).sum();
        let beyond = |(image, reach): (&Interval, &f64)| image.magnitude() / reach;
        Unproven::NotContracting {
            reach: most(&mut image.iter().zip(reach).map(beyond)),
            contraction: most(&mut rest.iter().map(sum)),
            step: most(&mut self.newton.iter().map(|step| step.magnitude())),
            width: most(&mut reach.iter().copied()),
        }
    }
}

fn dot(terms: usize, term: impl Fn(usize) -> Interval) -> Interval {
    (0..terms).fold(Interval::ZERO, |sum, k| sum + term(k))
}

//! Fields over boxes, of any number of states.

use crate::field::{EnclosedField, Unenclosed};
use crate::math::interval::Interval;
use crate::model::Model;

/// A field over a box.
#[derive(Debug, Clone, PartialEq)]
pub struct Enclosed {
    /// All values of f.
    pub f: Vec<Interval>,
    /// All values of ∂fᵢ/∂yⱼ, in row i and column j; at a kink those of both sides.
    pub jacobian: Vec<Vec<Interval>>,
}

/// A field that can be enclosed.
pub trait Enclosure {
    /// The number of states.
    fn order(&self) -> usize;

    /// The field over all states between these.
    ///
    /// # Errors
    /// A contact may stick there, or a law with internal state may be at one of its kinks or stops.
    fn over(&self, states: &[Interval]) -> Result<Enclosed, Unenclosed>;
}

impl<M: Model<N>, const N: usize> Enclosure for EnclosedField<M, N> {
    fn order(&self) -> usize {
        N
    }

    fn over(&self, states: &[Interval]) -> Result<Enclosed, Unenclosed> {
        let state = |j: usize| states.get(j).copied();
        let states = crate::scalar::filled(|j| state(j).unwrap_or(Interval::from(f64::NAN)));
        let field = EnclosedField::over(self, &states)?;
        Ok(Enclosed {
            f: field.f.to_vec(),
            jacobian: field.jacobian.map(|row| row.to_vec()).to_vec(),
        })
    }
}

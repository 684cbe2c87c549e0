//! Families whose design variable can be exchanged for another.

use super::{ExactFamily, Family, SmoothFamily};
use crate::field::Design;
use crate::model::Model;

/// A family that can be led along any of several design variables.
pub trait Steered<const N: usize>: Family<N> + Clone {
    /// The same family along `design`, with `fixed` held at `value` (of a smoothing: the logarithm of its size).
    #[must_use]
    fn steered(&self, design: Design, fixed: Design, value: f64) -> Self;
}

impl<M: Model<N>, const N: usize> Steered<N> for SmoothFamily<M, N> {
    fn steered(&self, design: Design, fixed: Design, value: f64) -> Self {
        let mut family = Self { design, ..*self };
        match (fixed, &mut family.smoothing) {
            (Design::Parameter(index), _) => family.model = with(&self.model, index, value),
            (Design::Smoothing, Some(smoothing)) => smoothing.size = value.exp(),
            _ => {}
        }
        family
    }
}

impl<M: Model<N>, const N: usize> Steered<N> for ExactFamily<M, N> {
    fn steered(&self, design: Design, fixed: Design, value: f64) -> Self {
        let index = |design| match design {
            Design::Parameter(index) => Some(index),
            Design::Smoothing | Design::None => None,
        };
        let model = index(fixed).map_or(self.model, |i| with(&self.model, i, value));
        Self {
            model,
            design: index(design),
            ..*self
        }
    }
}

fn with<M: Model<N>, const N: usize>(model: &M, index: usize, value: f64) -> M {
    let mut values = model.values();
    if let Some(place) = values.as_mut().get_mut(index) {
        *place = value;
    }
    M::from_values(values)
}

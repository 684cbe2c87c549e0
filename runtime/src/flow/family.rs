//! Flows that depend on a design variable.

use super::exact::ExactFlow;
use super::smooth::check_stops;
use super::{FlowError, SmoothFlow, standing};
use crate::field::{Design, SmoothField, Smoothing};
use crate::integrate::Tolerance;
use crate::model::{Model, ParamId};

/// A model without friction, or with one smoothing, along one design variable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SmoothFamily<M, const N: usize> {
    /// The model at the values of all parameters but the design variable.
    pub model: M,
    /// The smoothing of its contacts.
    pub smoothing: Option<Smoothing>,
    /// What r stands for.
    pub design: Design,
    /// Local tolerance of the integration.
    pub tolerance: Tolerance,
    /// Usual magnitudes of the states.
    pub magnitude: [f64; N],
}

impl<M: Model<N>, const N: usize> SmoothFamily<M, N> {
    /// The flow at r, with derivatives ∂/∂r.
    ///
    /// # Errors
    /// r is outside what the model declares, or its smoothing would falsify a law there.
    pub fn at(&self, r: f64) -> Result<SmoothFlow<M, N>, FlowError> {
        let mut values = self.model.values();
        let mut smoothing = self.smoothing;
        match (self.design, &mut smoothing) {
            (Design::Parameter(index), _) => {
                if let Some(value) = values.as_mut().get_mut(index) {
                    *value = r;
                }
            }
            (Design::Smoothing, Some(smoothing)) => smoothing.size = r.exp(),
            _ => {}
        }
        M::INFO.check(values.as_ref())?;
        standing::<M, N>(&values)?;
        let field = SmoothField::new(&M::from_values(values), smoothing, self.design)?;
        check_stops(&field)?;
        Ok(SmoothFlow::new(
            field.with_magnitude(self.magnitude),
            self.tolerance,
        ))
    }
}

/// A model with its declared friction, along one design variable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExactFamily<M, const N: usize> {
    /// The model at the values of all parameters but the design variable.
    pub model: M,
    /// Which parameter r stands for, if any.
    pub design: Option<usize>,
    /// Local tolerance of the integration.
    pub tolerance: Tolerance,
    /// Usual magnitudes of the states.
    pub magnitude: [f64; N],
}

impl<M: Model<N>, const N: usize> ExactFamily<M, N> {
    /// The flow at r, with derivatives ∂/∂r.
    ///
    /// # Errors
    /// r is outside what the model declares, or its law has stops.
    pub fn at(&self, r: f64) -> Result<ExactFlow<M, N>, FlowError> {
        let mut values = self.model.values();
        if let Some(value) = self.design.and_then(|index| values.as_mut().get_mut(index)) {
            *value = r;
        }
        M::INFO.check(values.as_ref())?;
        standing::<M, N>(&values)?;
        let design = self.design.map(ParamId::new);
        let flow = ExactFlow::new(&M::from_values(values), design, self.tolerance.explicit())?;
        Ok(flow.with_magnitude(self.magnitude))
    }
}

impl Design {
    /// The parameter that it is, if it is one.
    #[must_use]
    pub const fn parameter(self) -> Option<usize> {
        match self {
            Self::Parameter(index) => Some(index),
            Self::Smoothing | Self::None => None,
        }
    }
}

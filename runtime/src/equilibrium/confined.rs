//! How long an equilibrium of one mode is one of the system.

use crate::flow::exact::ExactFlow;
use crate::flow::{Flow, FlowError, Place, SmoothFlow};
use crate::model::Model;

/// A flow that knows where its modes end.
pub trait Confined<const N: usize>: Flow<N> {
    /// For each sliding contact its number and its relative speed the way it slides: not positive beyond the mode.
    fn margins(&self, at: &Place<N, Self::Mode>) -> Vec<(usize, f64)>;

    /// Whether the field stands for the system at this place.
    ///
    /// # Errors
    /// A one-directional smoothing is used backwards.
    fn check(&self, at: &Place<N, Self::Mode>) -> Result<(), FlowError>;
}

impl<M: Model<N>, const N: usize> Confined<N> for SmoothFlow<M, N> {
    fn margins(&self, _at: &Place<N, ()>) -> Vec<(usize, f64)> {
        Vec::new()
    }

    fn check(&self, at: &Place<N, ()>) -> Result<(), FlowError> {
        match self.field().backwards(&at.state) {
            Some((contact, speed)) => Err(FlowError::Backwards {
                contact,
                time: 0.0,
                speed,
            }),
            None => Ok(()),
        }
    }
}

impl<M: Model<N>, const N: usize> Confined<N> for ExactFlow<M, N> {
    fn margins(&self, at: &Place<N, Self::Mode>) -> Vec<(usize, f64)> {
        let (speeds, rounding) = self.speeds(&at.state);
        let signs = at.mode.as_slice().iter().map(|mode| mode.sign());
        signs
            .enumerate()
            .filter(|(_, sign)| *sign != 0.0)
            .map(|(i, sign)| (i, sign * speeds.as_ref()[i] - rounding.as_ref()[i]))
            .collect()
    }

    fn check(&self, _at: &Place<N, Self::Mode>) -> Result<(), FlowError> {
        Ok(())
    }
}

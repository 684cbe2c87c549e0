//! Flows that depend on a design variable.

use std::fmt;
use std::ops::Deref;
use std::sync::Arc;

use super::Flow;
use super::passage::fixed;
use super::tape::{Tape, Taped};
use crate::field::Design;
use crate::flow::{ExactFamily, FlowError, SmoothFamily};
use crate::integrate::Tolerance;
use crate::model::Model;

/// One flow for each value of a design variable r.
pub trait Flows: Send + Sync {
    /// The number of states.
    #[must_use]
    fn order(&self) -> usize;

    /// The state that is the phase of a drive, if there is one.
    #[must_use]
    fn phase(&self) -> Option<usize>;

    /// The flow at r, with derivatives ∂/∂r.
    ///
    /// # Errors
    /// r is outside what the model declares, or its smoothing would falsify a law there.
    fn at(&self, r: f64) -> Result<Box<dyn Flow>, FlowError>;

    /// The same flows, integrated to another tolerance.
    #[must_use]
    fn with_tolerance(&self, tolerance: Tolerance) -> Family;

    /// The same flows, their states measured against these magnitudes where they pass through zero.
    #[must_use]
    fn with_magnitude(&self, magnitude: &[f64]) -> Family;

    /// The same flows along `design`, with `fixed` held at `value` (of a smoothing: the logarithm of its size).
    #[must_use]
    fn steered(&self, design: Design, fixed: Design, value: f64) -> Family;
}

/// A family of flows that is cheap to clone: what all searches and branches are given.
#[derive(Clone)]
pub struct Family(Arc<dyn Flows>);

impl<F: Flows + 'static> From<F> for Family {
    fn from(flows: F) -> Self {
        Self(Arc::new(flows))
    }
}

impl fmt::Debug for Family {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a family of flows of order {}", self.order())
    }
}

impl Deref for Family {
    type Target = dyn Flows;

    fn deref(&self) -> &Self::Target {
        self.0.as_ref()
    }
}

impl Family {
    /// The same flows, their passages kept on a tape.
    #[must_use]
    pub fn recorded(&self, tape: &Arc<Tape>) -> Self {
        let (family, tape) = (self.clone(), tape.clone());
        Taped { family, tape }.into()
    }
}

/// What smooth and exact families answer in the same words.
macro_rules! alike {
    () => {
        fn order(&self) -> usize {
            N
        }

        fn phase(&self) -> Option<usize> {
            M::INFO.drive
        }

        fn at(&self, r: f64) -> Result<Box<dyn Flow>, FlowError> {
            Ok(Box::new(self.at(r)?))
        }

        fn with_tolerance(&self, tolerance: Tolerance) -> Family {
            Self { tolerance, ..*self }.into()
        }

        fn with_magnitude(&self, magnitude: &[f64]) -> Family {
            let magnitude = fixed(magnitude);
            Self { magnitude, ..*self }.into()
        }
    };
}

impl<M: Model<N>, const N: usize> Flows for SmoothFamily<M, N> {
    alike!();

    fn steered(&self, design: Design, fixed: Design, value: f64) -> Family {
        let mut family = Self { design, ..*self };
        match (fixed, &mut family.smoothing) {
            (Design::Parameter(index), _) => family.model = with(&self.model, index, value),
            (Design::Smoothing, Some(smoothing)) => smoothing.size = value.exp(),
            _ => {}
        }
        family.into()
    }
}

impl<M: Model<N>, const N: usize> Flows for ExactFamily<M, N> {
    alike!();

    fn steered(&self, design: Design, fixed: Design, value: f64) -> Family {
        let mut family = *self;
        if let Design::Parameter(index) = fixed {
            family.model = with(&self.model, index, value);
        }
        family.design = design.parameter();
        family.into()
    }
}

fn with<M: Model<N>, const N: usize>(model: &M, index: usize, value: f64) -> M {
    let mut values = model.values();
    if let Some(place) = values.as_mut().get_mut(index) {
        *place = value;
    }
    M::from_values(values)
}

//! What only the model itself can answer: the one place above the flows that is generic over it.

use std::marker::PhantomData;

use crate::field::exact::{ExactSystem, Mode, Modes};
use crate::field::{EnclosedField, Smoothing};
use crate::flow::{ExactFamily, SmoothFamily};
use crate::integrate::Tolerance;
use crate::model::{Model, ModelInfo};
use crate::motion::exact::fixed_modes;
use crate::motion::{Enclosure, Family, fixed};
use crate::scalar::Inline;
use crate::shooting::Orbit;
use crate::study::law::{Acting, Laws};
use crate::study::predict::{PredictError, Prediction, Rubbed, predict};
use crate::study::question::{Case, Dynamics};

/// A declared model, whatever its type and its number of states.
pub(super) trait Physics: Send + Sync {
    /// The model as data.
    fn info(&self) -> &'static ModelInfo;

    /// The flows that a case is about, along its design variable.
    fn family(&self, case: &Case) -> Family;

    /// Shows the law of each contact and each law with internal state.
    fn laws(&self, case: &Case, start: &[f64], see: &mut dyn FnMut(Acting<'_>));

    /// Its field over boxes: sliding in these modes, or else smooth.
    fn enclosure(&self, case: &Case, modes: Option<&[Mode]>) -> Box<dyn Enclosure>;

    /// The fastest rate that a copy adds at a state: see [`Point::stiffness`](crate::study::trade::Point).
    fn stiffness(&self, case: &Case, state: &[f64], copy: Smoothing) -> f64;

    /// The errors of the copy with this smoothing, predicted from the exact orbit.
    fn predict(
        &self,
        case: &Case,
        orbit: &Orbit,
        copy: Smoothing,
    ) -> Result<Prediction, PredictError>;
}

/// The model `M` with its number of states, which nobody else needs to know.
pub(super) struct Of<M, const N: usize>(PhantomData<fn() -> M>);

impl<M: Model<N>, const N: usize> Of<M, N> {
    /// Whether there are contacts to be exact about. What only such a model needs is not compiled for the others.
    const TOUCHES: bool = M::INFO.touches();
    /// Whether nothing but dry friction touches.
    const RUBS: bool = Self::TOUCHES && M::INFO.presses.is_empty();

    pub(super) const fn new() -> Self {
        Self(PhantomData)
    }
}

fn model<M: Model<N>, const N: usize>(case: &Case) -> M {
    let default = M::default().values();
    M::from_values(Inline::from_fn(|i| {
        let value = case.parameters.get(i).copied();
        value.unwrap_or(default.as_ref()[i])
    }))
}

impl<M: Model<N>, const N: usize> Physics for Of<M, N> {
    fn info(&self) -> &'static ModelInfo {
        M::INFO
    }

    fn family(&self, case: &Case) -> Family {
        let (model, magnitude) = (model::<M, N>(case), [1.0; N]);
        let tolerance = Tolerance::for_accuracy(case.accuracy);
        let design = case.design();
        if const { Self::TOUCHES } {
            if case.dynamics == Dynamics::Exact {
                let family = ExactFamily {
                    model,
                    design: design.parameter(),
                    tolerance,
                    magnitude,
                };
                return family.into();
            }
        }
        let family = SmoothFamily {
            model,
            smoothing: case.smoothing(),
            design,
            tolerance,
            magnitude,
        };
        family.into()
    }

    fn laws(&self, case: &Case, start: &[f64], see: &mut dyn FnMut(Acting<'_>)) {
        let values = model::<M, N>(case).values();
        let rubbing = M::INFO.contacts.len();
        let mut laws = Laws { see, rubbing };
        let _ = M::rhs(&values, fixed(start), &mut laws);
    }

    fn enclosure(&self, case: &Case, sliding: Option<&[Mode]>) -> Box<dyn Enclosure> {
        let model: M = model(case);
        Box::new(match sliding {
            Some(sliding) => EnclosedField::sliding(&model, fixed_modes(sliding)),
            None => EnclosedField::smooth(&model, case.smoothing()),
        })
    }

    fn stiffness(&self, case: &Case, at: &[f64], copy: Smoothing) -> f64 {
        let system = ExactSystem::<M, N>::new(&model(case), None);
        let at = fixed(at);
        let held = system.affine(&at, &Modes::held());
        let rubs = |i: usize| held.compliance.as_ref()[i].as_ref()[i] * held.stick.as_ref()[i];
        let rubbing = (0..M::INFO.contacts.len()).map(rubs).fold(0.0, f64::max);
        let rubbing = copy.steepness() * copy.sharpness() * rubbing;
        if M::INFO.presses.is_empty() {
            return rubbing;
        }
        let resting = Modes::from_fn(|i| match M::INFO.is_rigid(i) {
            true => Mode::Rest,
            false if i < M::INFO.contacts.len() => Mode::Loose,
            false => Mode::Open,
        });
        let closed = system.affine(&at, &resting);
        let walls = (0..resting.as_slice().len()).filter(|&i| M::INFO.is_rigid(i));
        let wall = |i: usize| (copy.sharpness() * closed.compliance.as_ref()[i].as_ref()[i]).sqrt();
        walls.map(wall).fold(rubbing, f64::max)
    }

    fn predict(
        &self,
        case: &Case,
        orbit: &Orbit,
        copy: Smoothing,
    ) -> Result<Prediction, PredictError> {
        if let Some(press) = M::INFO.presses.first() {
            return Err(PredictError::Press { press: press.name });
        }
        if const { Self::RUBS } {
            predict(&Rubbed::<M, N>::new(model(case)), orbit, copy)
        } else {
            Err(PredictError::NeverSticks)
        }
    }
}

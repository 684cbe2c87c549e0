//! What only the model itself can answer: the one place above the flows that is generic over it.

use std::marker::PhantomData;

use crate::field::exact::{ExactSystem, Mode, Modes};
use crate::field::{Design, EnclosedField, Smoothing};
use crate::flow::{ExactFamily, SmoothFamily};
use crate::integrate::Tolerance;
use crate::model::{Model, ModelInfo};
use crate::motion::exact::fixed_modes;
use crate::motion::{Enclosure, Family, fixed};
use crate::scalar::Inline;
use crate::shooting::Orbit;
use crate::study::law::{Acting, Laws};
use crate::study::predict::{PredictError, Prediction, Rubbed, predict};

/// A declared model, whatever its type and its number of states.
pub(super) trait Physics: Send + Sync {
    /// The model as data.
    fn info(&self) -> &'static ModelInfo;

    /// Its flows along a design variable, with friction as declared; smooth where it has none.
    fn exact(&self, values: &[f64], design: Design, tolerance: Tolerance) -> Family;

    /// Its flows along a design variable, with this smoothing of its friction.
    fn smooth(
        &self,
        values: &[f64],
        smoothing: Option<Smoothing>,
        design: Design,
        tolerance: Tolerance,
    ) -> Family;

    /// Shows the law of each contact and each law with internal state.
    fn laws(&self, values: &[f64], start: &[f64], see: &mut dyn FnMut(Acting<'_>));

    /// Its field over boxes: sliding in these modes, or else with this smoothing.
    fn enclosure(
        &self,
        values: &[f64],
        modes: Option<&[Mode]>,
        smoothing: Option<Smoothing>,
    ) -> Box<dyn Enclosure>;

    /// stick · G of each contact at a state, all of them held; the largest.
    fn stiffness(&self, values: &[f64], state: &[f64]) -> f64;

    /// The errors of the copy with this smoothing, predicted from the exact orbit.
    fn predict(
        &self,
        values: &[f64],
        orbit: &Orbit,
        smoothing: Smoothing,
    ) -> Result<Prediction, PredictError>;
}

/// The model `M` with its number of states, which nobody else needs to know.
pub(super) struct Of<M, const N: usize>(PhantomData<fn() -> M>);

impl<M: Model<N>, const N: usize> Of<M, N> {
    /// Whether there is friction to be exact about. What only such a model needs is not compiled for the others.
    const RUBS: bool = !M::INFO.contacts.is_empty();

    pub(super) const fn new() -> Self {
        Self(PhantomData)
    }
}

fn model<M: Model<N>, const N: usize>(values: &[f64]) -> M {
    let default = M::default().values();
    M::from_values(Inline::from_fn(|i| {
        values.get(i).copied().unwrap_or(default.as_ref()[i])
    }))
}

impl<M: Model<N>, const N: usize> Physics for Of<M, N> {
    fn info(&self) -> &'static ModelInfo {
        M::INFO
    }

    fn exact(&self, values: &[f64], design: Design, tolerance: Tolerance) -> Family {
        if const { Self::RUBS } {
            let parameter = match design {
                Design::Parameter(index) => Some(index),
                Design::Smoothing | Design::None => None,
            };
            let family: ExactFamily<M, N> = ExactFamily {
                model: model(values),
                design: parameter,
                tolerance,
                magnitude: [1.0; N],
            };
            family.into()
        } else {
            self.smooth(values, None, design, tolerance)
        }
    }

    fn smooth(
        &self,
        values: &[f64],
        smoothing: Option<Smoothing>,
        design: Design,
        tolerance: Tolerance,
    ) -> Family {
        let family: SmoothFamily<M, N> = SmoothFamily {
            model: model(values),
            smoothing,
            design,
            tolerance,
            magnitude: [1.0; N],
        };
        family.into()
    }

    fn laws(&self, values: &[f64], start: &[f64], see: &mut dyn FnMut(Acting<'_>)) {
        let values = model::<M, N>(values).values();
        let _ = M::rhs(&values, fixed(start), &mut Laws(see));
    }

    fn enclosure(
        &self,
        values: &[f64],
        sliding: Option<&[Mode]>,
        smoothing: Option<Smoothing>,
    ) -> Box<dyn Enclosure> {
        let model: M = model(values);
        Box::new(match sliding {
            Some(sliding) => EnclosedField::sliding(&model, fixed_modes(sliding)),
            None => EnclosedField::smooth(&model, smoothing),
        })
    }

    fn stiffness(&self, values: &[f64], at: &[f64]) -> f64 {
        let system = ExactSystem::<M, N>::new(&model(values), None);
        let affine = system.affine(&fixed(at), &Modes::from_fn(|_| Mode::Stick));
        let of = |i: usize| affine.compliance.as_ref()[i].as_ref()[i] * affine.stick.as_ref()[i];
        (0..M::INFO.contacts.len()).map(of).fold(0.0, f64::max)
    }

    fn predict(
        &self,
        values: &[f64],
        orbit: &Orbit,
        smoothing: Smoothing,
    ) -> Result<Prediction, PredictError> {
        if const { Self::RUBS } {
            predict(&Rubbed::<M, N>::new(model(values)), orbit, smoothing)
        } else {
            Err(PredictError::NeverSticks)
        }
    }
}

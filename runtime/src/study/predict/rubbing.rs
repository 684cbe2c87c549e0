//! What a prediction asks of the model itself: all that follows from the answers is compiled once.

use num_dual::Dual64;

use super::PredictError;
use super::history::{History, TIGHT};
use super::response::{Response, response};
use crate::field::exact::{ContactError, ExactSystem, Mode, solve};
use crate::field::{Smoothed, Smoothing};
use crate::flow::FlowError;
use crate::flow::exact::ExactFlow;
use crate::friction::{ContactRule, FrictionLaw};
use crate::model::{ContactId, Model};
use crate::motion::exact::place;
use crate::motion::{Flow, Place, fixed};
use crate::scalar::Inline;

/// A model with set-valued friction, whatever its type.
pub(crate) trait Rubbing {
    /// The contact of this number.
    fn contact_id(&self, number: usize) -> ContactId;

    /// The flow that the prediction starts from.
    fn flow(&self) -> Result<Box<dyn Flow>, FlowError>;

    /// What acts on a contact that sticks.
    fn load(&self, at: &Place, contact: usize) -> Result<Load, ContactError>;

    /// ẇ of a contact that slides, and slip(0⁺).
    fn approach(&self, at: &Place, contact: usize) -> Result<(f64, f64), ContactError>;

    /// The force of one law at a speed of one's own choice: the exact one, or that of a copy.
    fn force(
        &self,
        state: &[f64],
        contact: usize,
        speed: Dual64,
        copy: Option<&Smoothing>,
    ) -> Dual64;

    /// The response at `times` (in order, the last is the period) to the losses in `history`.
    fn response(&self, history: &History, times: &[f64]) -> Result<Vec<Response>, PredictError>;
}

/// What acts on a contact that sticks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Load {
    /// G with all other contacts as they are.
    pub(super) compliance: f64,
    /// |λ̇|.
    pub(super) rate: f64,
    /// Largest force at rest.
    pub(super) stick: f64,
    /// slip(0⁺).
    pub(super) slip: f64,
}

/// A model at given values of its parameters.
pub(in super::super) struct Rubbed<M: Model<N>, const N: usize> {
    pub(super) model: M,
    pub(super) system: ExactSystem<M, N>,
}

impl<M: Model<N>, const N: usize> Rubbed<M, N> {
    pub(in super::super) fn new(model: M) -> Self {
        let system = ExactSystem::new(&model, None);
        Self { model, system }
    }
}

impl<M: Model<N>, const N: usize> Rubbing for Rubbed<M, N> {
    fn contact_id(&self, number: usize) -> ContactId {
        M::INFO.contact_id(number)
    }

    fn flow(&self) -> Result<Box<dyn Flow>, FlowError> {
        Ok(Box::new(ExactFlow::new(&self.model, None, TIGHT)?))
    }

    fn load(&self, at: &Place, contact: usize) -> Result<Load, ContactError> {
        let (at, system) = (place(at), &self.system);
        let moving = system.moving(&at.state, &at.mode)?;
        let affine = system.affine(&at.state, &at.mode);
        let mut unit: M::PerContact<f64> = Inline::from_fn(|j| f64::from(contact == j));
        let (mut rows, held) = (affine.compliance, at.mode.which(|mode| mode == Mode::Stick));
        let solved = solve(rows.as_mut(), unit.as_mut(), held.as_ref());
        let response = solved.map_or(f64::NAN, |()| unit.as_ref()[contact]);
        Ok(Load {
            compliance: 1.0 / response,
            rate: moving.force.as_ref()[contact].eps.abs(),
            stick: moving.stick.as_ref()[contact].re,
            slip: system.limits_at_rest(&at.state).as_ref()[contact].1,
        })
    }

    fn approach(&self, at: &Place, contact: usize) -> Result<(f64, f64), ContactError> {
        let (at, system) = (place(at), &self.system);
        let field = system.snapshot(&at.state, &at.mode)?.field;
        let rate = system.rates_along(&at.state, &at.mode, &field).as_ref()[contact];
        Ok((rate, system.limits_at_rest(&at.state).as_ref()[contact].1))
    }

    fn force(
        &self,
        state: &[f64],
        contact: usize,
        speed: Dual64,
        copy: Option<&Smoothing>,
    ) -> Dual64 {
        let mut asked = Asked {
            contact,
            speed,
            copy: copy.map(|smoothing| Smoothed {
                kernel: smoothing.kernel,
                sharpness: Dual64::from(smoothing.sharpness()),
            }),
            force: Dual64::from(0.0),
        };
        let values = self.system.values().as_ref();
        let params = Inline::from_fn(|i| Dual64::from(values[i]));
        let _ = M::rhs(&params, fixed(state).map(Dual64::from), &mut asked);
        asked.force
    }

    fn response(&self, history: &History, times: &[f64]) -> Result<Vec<Response>, PredictError> {
        response(self, history, times)
    }
}

/// Asks one law for its force at a speed of one's own choice.
struct Asked {
    contact: usize,
    speed: Dual64,
    copy: Option<Smoothed<Dual64>>,
    force: Dual64,
}

impl ContactRule<Dual64> for Asked {
    fn force<L: FrictionLaw<Dual64>>(&mut self, contact: usize, law: &L, _: Dual64) -> Dual64 {
        if contact == self.contact {
            self.force = match &mut self.copy {
                Some(copy) => copy.force(contact, law, self.speed),
                None => {
                    let sign = if self.speed.re < 0.0 { -1.0 } else { 1.0 };
                    -law.slip(self.speed * sign) * sign
                }
            };
        }
        Dual64::from(0.0)
    }
}

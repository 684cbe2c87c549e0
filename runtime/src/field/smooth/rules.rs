//! What the field asks of the laws besides their smoothed forces.

use crate::field::smoothing::{Smoothing, SmoothingError, rebounds};
use crate::friction::{ContactRule, ForceSlopes, FrictionLaw, SlopeRule};
use crate::model::{Model, ModelInfo};
use crate::press::PressLaw;
use crate::scalar::Scalar;

/// A smoothing must not turn a law into another one.
pub(super) fn accept<M: Model<N>, const N: usize>(
    values: &M::Params<f64>,
    smoothing: &Smoothing,
) -> Result<(), SmoothingError> {
    let mut levels = Levels {
        verdict: Ok(()),
        smoothing,
        info: M::INFO,
    };
    let start = crate::scalar::filled(|i| M::INFO.states[i].start);
    let _ = M::rhs(values, start, &mut levels);
    levels.verdict
}

/// Compares each law's limit at rest with the force at which sliding starts, all presses pushing with a unit of force.
struct Levels<'a> {
    verdict: Result<(), SmoothingError>,
    smoothing: &'a Smoothing,
    info: &'static ModelInfo,
}

impl ContactRule<f64> for Levels<'_> {
    fn force<L: FrictionLaw<f64>>(&mut self, contact: usize, law: &L, _speed: f64) -> f64 {
        if self.verdict.is_ok() {
            let name = self.info.contacts[contact].name;
            self.verdict = self.smoothing.kernel.suits(law, Some(name));
        }
        0.0
    }

    fn press<L: PressLaw<f64>>(&mut self, contact: usize, law: &L, _gap: f64, _rate: f64) -> f64 {
        if self.verdict.is_ok() {
            self.verdict = rebounds(law, self.info.contact(contact).unwrap_or_default());
        }
        1.0
    }
}

/// Visits the gaps.
pub(super) struct Gaps<V>(pub(super) V);

impl<V: FnMut(usize, f64)> ContactRule<f64> for Gaps<V> {
    #[inline]
    fn force<L: FrictionLaw<f64>>(&mut self, _contact: usize, _law: &L, _speed: f64) -> f64 {
        0.0
    }

    #[inline]
    fn press<L: PressLaw<f64>>(&mut self, contact: usize, _law: &L, gap: f64, _rate: f64) -> f64 {
        (self.0)(contact, gap);
        0.0
    }
}

/// Visits the rates of the gaps of presses that do not give way.
pub(super) struct Turns<V>(pub(super) V);

impl<V: FnMut(usize, f64)> ContactRule<f64> for Turns<V> {
    #[inline]
    fn force<L: FrictionLaw<f64>>(&mut self, _contact: usize, _law: &L, _speed: f64) -> f64 {
        0.0
    }

    #[inline]
    fn press<L: PressLaw<f64>>(&mut self, contact: usize, _law: &L, _gap: f64, rate: f64) -> f64 {
        if L::INFO.is_rigid() {
            (self.0)(contact, rate);
        }
        0.0
    }
}

/// Visits the relative speeds; the forces are zero, so nothing else is computed.
pub(super) struct Speeds<V>(pub(super) V);

impl<D: Scalar, V: FnMut(usize, D)> ContactRule<D> for Speeds<V> {
    #[inline]
    fn force<L: FrictionLaw<D>>(&mut self, contact: usize, _law: &L, speed: D) -> D {
        (self.0)(contact, speed);
        D::from(0.0)
    }
}

/// Forces as steep as they are inside a layer, wherever the motion is.
pub(super) struct Layer {
    pub(super) steepness: f64,
}

impl SlopeRule for Layer {
    fn force<L: FrictionLaw<f64>>(
        &mut self,
        _contact: usize,
        law: &L,
        _along: &L,
        _speed: f64,
    ) -> ForceSlopes {
        ForceSlopes {
            force: 0.0,
            by_speed: -self.steepness * law.stick(),
            along: 0.0,
            by_design: 0.0,
        }
    }
}

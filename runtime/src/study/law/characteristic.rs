//! Friction force against sliding speed, whatever the type of the law.

use super::hysteresis::{Hysteresis, Shaken};
use super::strike::{Strike, Struck};
use crate::field::{Smoothed, Smoothing, SmoothingError};
use crate::friction::{ContactRule, FrictionLaw, LawInfo};
use crate::memory::{Answer, MemoryLaw};
use crate::press::{PressLaw, pressing};

/// A friction law at given values of its parameters.
pub trait Characteristic {
    /// The law as data.
    fn law(&self) -> &'static LawInfo;

    /// Largest magnitude of the force at rest.
    fn at_rest(&self) -> f64;

    /// Magnitude of the force at the sliding speed `speed` > 0; at 0, its limit.
    fn sliding(&self, speed: f64) -> f64;

    /// The force of a smooth copy against the relative speed `speed`: positive where the exact one is.
    fn copied(&self, smoothing: Smoothing, speed: f64) -> f64;

    /// Whether a smoothing leaves the law what it is.
    ///
    /// # Errors
    /// The copy would converge to another law, or never stick.
    fn accepts(&self, smoothing: Smoothing) -> Result<(), SmoothingError>;
}

impl<L: FrictionLaw<f64>> Characteristic for L {
    fn law(&self) -> &'static LawInfo {
        L::INFO
    }

    fn at_rest(&self) -> f64 {
        self.stick()
    }

    fn sliding(&self, speed: f64) -> f64 {
        self.slip(speed)
    }

    fn copied(&self, smoothing: Smoothing, speed: f64) -> f64 {
        let mut rule = Smoothed {
            kernel: smoothing.kernel,
            sharpness: smoothing.sharpness(),
        };
        -rule.force(0, self, speed)
    }

    fn accepts(&self, smoothing: Smoothing) -> Result<(), SmoothingError> {
        smoothing.kernel.suits(self, None)
    }
}

/// A law as it acts in a model.
pub enum Acting<'a> {
    /// Of the contact of this number.
    Static(usize, &'a dyn Characteristic),
    /// Of the friction of this number among those with internal state.
    Remembering(usize, &'a dyn Hysteresis),
    /// Of the press of this number among those, and its gap.
    Pressing(usize, &'a dyn Strike, f64),
}

/// Shows the law of each contact, and each law with internal state; the forces of contacts that rub are zero.
pub(in crate::study) struct Laws<'a> {
    pub(in crate::study) see: &'a mut dyn FnMut(Acting<'_>),
    /// How many contacts rub.
    pub(in crate::study) rubbing: usize,
}

impl ContactRule<f64> for Laws<'_> {
    fn force<L: FrictionLaw<f64>>(&mut self, contact: usize, law: &L, _speed: f64) -> f64 {
        (self.see)(Acting::Static(contact, law));
        0.0
    }

    fn press<L: PressLaw<f64>>(&mut self, contact: usize, law: &L, gap: f64, rate: f64) -> f64 {
        let struck = Struck::<&L, L>::new(law, None);
        (self.see)(Acting::Pressing(contact - self.rubbing, &struck, gap));
        pressing(law, gap, rate)
    }

    fn recall<L: MemoryLaw<f64, S>, const S: usize>(
        &mut self,
        element: usize,
        law: &L,
        memory: [f64; S],
        speed: f64,
    ) -> Answer<f64, S> {
        let shaken = Shaken::<&L, L, S>::new(law, None);
        (self.see)(Acting::Remembering(element, &shaken));
        law.answer(memory, speed)
    }
}

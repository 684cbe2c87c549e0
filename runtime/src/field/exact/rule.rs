//! The rules that answer for a force in a given mode, one of which notes what it was asked.

use std::marker::PhantomData;

use super::mode::{Mode, Modes};
use super::twin::{beside, twins};
use crate::friction::{ContactRule, FrictionLaw};
use crate::memory::{Answer, MemoryLaw};
use crate::model::Model;
use crate::press::{PressLaw, Pressed};
use crate::scalar::{Inline, Scalar};

/// Forces by their laws, none where a contact sticks or is at rest: all that the field needs, which is asked most.
pub(super) struct Sliding<'a, M, const N: usize> {
    modes: &'a [Mode],
    model: PhantomData<M>,
}

impl<'a, M: Model<N>, const N: usize> Sliding<'a, M, N> {
    #[inline]
    pub(super) fn new(modes: &'a [Mode]) -> Self {
        Self {
            modes,
            model: PhantomData,
        }
    }
}

impl<M: Model<N>, D: Scalar, const N: usize> ContactRule<D> for Sliding<'_, M, N> {
    #[inline]
    fn force<L: FrictionLaw<D>>(&mut self, contact: usize, law: &L, speed: D) -> D {
        match self.modes.get(contact) {
            Some(Mode::SlideForward) => -slip(law, speed),
            Some(Mode::SlideBackward) => slip(law, -speed),
            Some(&mode) if const { Modes::<M, N>::PRESSED } => held(mode, law),
            _ => D::from(0.0),
        }
    }

    #[inline]
    fn press<L: PressLaw<D>>(&mut self, contact: usize, law: &L, gap: D, rate: D) -> D {
        match self.modes.get(contact) {
            Some(Mode::Closed) if !L::INFO.is_rigid() => Pressed::new(law, gap, rate).force,
            _ => D::from(0.0),
        }
    }

    #[inline]
    fn recall<L: MemoryLaw<D, S>, const S: usize>(
        &mut self,
        element: usize,
        law: &L,
        memory: [D; S],
        speed: D,
    ) -> Answer<D, S> {
        let twin = const { twins::<M, N>() }.get(element).copied().flatten();
        let sign = twin.and_then(|contact| self.modes.get(contact));
        match sign.map_or(0.0, |mode| mode.sign()) {
            0.0 => law.answer(memory, speed),
            sign => beside(law, memory, speed, sign),
        }
    }
}

/// Forces of the sliding contacts by their laws, of those that stick or are at rest as given.
pub(super) struct Branches<'a, M: Model<N>, D: Scalar, const N: usize> {
    modes: &'a [Mode],
    given: M::PerContact<D>,
    pub(super) speed: M::PerContact<D>,
    pub(super) force: M::PerContact<D>,
    /// The largest force at rest; of a press that is not open, what holds it closed while it is positive.
    pub(super) stick: M::PerContact<D>,
}

impl<'a, M: Model<N>, D: Scalar, const N: usize> Branches<'a, M, D, N> {
    /// No force where a contact sticks.
    #[inline]
    pub(super) fn free(modes: &'a [Mode]) -> Self {
        Self::with(modes, Inline::from_fn(|_| D::from(0.0)))
    }

    /// These forces where a contact sticks.
    #[inline]
    pub(super) fn with(modes: &'a [Mode], given: M::PerContact<D>) -> Self {
        let zero = D::from(0.0);
        Self {
            modes,
            given,
            speed: Inline::from_fn(|_| zero),
            force: Inline::from_fn(|_| zero),
            stick: Inline::from_fn(|_| zero),
        }
    }
}

impl<M: Model<N>, D: Scalar, const N: usize> ContactRule<D> for Branches<'_, M, D, N> {
    #[inline]
    fn force<L: FrictionLaw<D>>(&mut self, contact: usize, law: &L, speed: D) -> D {
        let Some(&mode) = self.modes.get(contact) else {
            return D::from(0.0);
        };
        let force = match mode {
            Mode::Stick => self.given.as_ref()[contact],
            _ => Sliding::<M, N>::new(self.modes).force(contact, law, speed),
        };
        self.speed.as_mut()[contact] = speed;
        self.force.as_mut()[contact] = force;
        self.stick.as_mut()[contact] = law.stick();
        force
    }

    /// A press is a contact whose gap stands where others have their speed; where it is at rest, the rate of that.
    #[inline]
    fn press<L: PressLaw<D>>(&mut self, contact: usize, law: &L, gap: D, rate: D) -> D {
        let mode = self.modes.get(contact).copied().unwrap_or(Mode::Open);
        if mode == Mode::Rest {
            let reaction = self.given.as_ref()[contact];
            self.speed.as_mut()[contact] = rate;
            self.force.as_mut()[contact] = reaction;
            self.stick.as_mut()[contact] = reaction;
            return reaction;
        }
        self.speed.as_mut()[contact] = gap;
        if L::INFO.is_rigid() {
            return D::from(0.0);
        }
        if mode == Mode::Open || !mode.is_of_press() {
            return D::from(0.0);
        }
        let pressed = Pressed::new(law, gap, rate);
        self.stick.as_mut()[contact] = pressed.hold;
        if mode == Mode::Closed {
            self.force.as_mut()[contact] = pressed.force;
            return pressed.force;
        }
        D::from(0.0)
    }

    #[inline]
    fn recall<L: MemoryLaw<D, S>, const S: usize>(
        &mut self,
        element: usize,
        law: &L,
        memory: [D; S],
        speed: D,
    ) -> Answer<D, S> {
        Sliding::<M, N>::new(self.modes).recall(element, law, memory, speed)
    }
}

/// The force of a contact that presses hold as it moves: at its limit, or none where they are open.
fn held<D: Scalar, L: FrictionLaw<D>>(mode: Mode, law: &L) -> D {
    match mode {
        Mode::PinnedForward => -law.stick(),
        Mode::PinnedBackward => law.stick(),
        _ => D::from(0.0),
    }
}

/// slip(s), continued to s < 0 by reflection in the point (0, slip(0)): stages that overshoot a surface
/// then meet neither a kink in the first derivative nor a pole of the law.
#[inline]
fn slip<D: Scalar, L: FrictionLaw<D>>(law: &L, speed: D) -> D {
    if speed.re() >= 0.0 {
        law.slip(speed)
    } else {
        law.slip(D::from(0.0)) * 2.0 - law.slip(-speed)
    }
}

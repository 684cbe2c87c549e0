//! The field over a box: all its values there, and all values of its Jacobian.

use num_traits::Signed;

use super::exact::{Mode, Modes};
use super::smoothing::{Kernel, Smoothing, bump_of};
use crate::friction::{ContactRule, FrictionLaw};
use crate::math::enclosure::Enclosure;
use crate::math::interval::Interval;
use crate::memory::{Answer, MemoryLaw};
use crate::model::Model;
use crate::press::PressLaw;
use crate::scalar::{Inline, mapped};

/// A field over a box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Enclosed<const N: usize> {
    /// All values of f.
    pub f: [Interval; N],
    /// All values of ∂fᵢ/∂yⱼ, in row i and column j; at a kink those of both sides.
    pub jacobian: [[Interval; N]; N],
}

/// Why a field cannot be enclosed over a box.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum Unenclosed {
    /// A contact that should slide one way may rest or turn.
    #[error(
        "the relative speed of `{name}` may vanish there, and a contact at rest has a set of forces"
    )]
    MayStick {
        /// Name of the contact's force.
        name: &'static str,
    },
    /// A contact that may press or not.
    #[error("the gap of `{name}` may open or close there, and so its force may begin or end")]
    MayTouch {
        /// Name of the contact's force.
        name: &'static str,
    },
    /// A law with internal state that may be on one of its kinks or stops.
    #[error(
        "the law of `{name}` may be at one of its kinks or stops there, where it has no derivative"
    )]
    MayTurn {
        /// Name of the force.
        name: &'static str,
    },
}

/// The field of a model for boxes; its parameters are exactly their doubles, and so are the constants of its formulas, as
/// a compiler folds them.
pub struct EnclosedField<M: Model<N>, const N: usize> {
    params: M::Params<Enclosure<N>>,
    friction: Friction<M, N>,
}

/// How contacts act.
enum Friction<M: Model<N>, const N: usize> {
    Sliding(Modes<M, N>),
    Smoothed(Smoothing),
    Absent,
}

impl<M: Model<N>, const N: usize> EnclosedField<M, N> {
    /// The exact field while every contact slides as `modes` say.
    #[must_use]
    pub fn sliding(model: &M, modes: Modes<M, N>) -> Self {
        Self::new(model, Friction::Sliding(modes))
    }

    /// The field of a smooth copy, or of a model without friction.
    #[must_use]
    pub fn smooth(model: &M, smoothing: Option<Smoothing>) -> Self {
        let friction = smoothing.map_or(Friction::Absent, Friction::Smoothed);
        Self::new(model, friction)
    }

    fn new(model: &M, friction: Friction<M, N>) -> Self {
        let values = model.values();
        let params = Inline::from_fn(|i| Enclosure::from(values.as_ref()[i]));
        Self { params, friction }
    }

    /// The field over all states between these.
    ///
    /// # Errors
    /// A contact may stick or let go there, or a law with internal state may be at a kink.
    pub fn over(&self, states: &[Interval; N]) -> Result<Enclosed<N>, Unenclosed> {
        let mut rule = Rule {
            friction: &self.friction,
            at_rest: None,
            at_kink: None,
        };
        let coordinates = crate::scalar::filled(|j| Enclosure::coordinate(states[j], j));
        let field = M::rhs(&self.params, coordinates, &mut rule);
        if let Some(contact) = rule.at_rest {
            let name = M::INFO.contact(contact).unwrap_or("?");
            return Err(if contact < M::INFO.contacts.len() {
                Unenclosed::MayStick { name }
            } else {
                Unenclosed::MayTouch { name }
            });
        }
        if let Some(element) = rule.at_kink {
            let name = M::INFO.memories.get(element).map_or("?", |m| m.name);
            return Err(Unenclosed::MayTurn { name });
        }
        Ok(Enclosed {
            f: mapped(&field, |row| row.value),
            jacobian: mapped(&field, |row| row.slopes),
        })
    }
}

/// Answers for forces over a box, and notes the first contact whose speed does not keep its sign there, and the first
/// law with internal state that does not keep to one side of each of its kinks and stops.
struct Rule<'a, M: Model<N>, const N: usize> {
    friction: &'a Friction<M, N>,
    at_rest: Option<usize>,
    at_kink: Option<usize>,
}

impl<M: Model<N>, const N: usize> ContactRule<Enclosure<N>> for Rule<'_, M, N> {
    fn force<L: FrictionLaw<Enclosure<N>>>(
        &mut self,
        contact: usize,
        law: &L,
        speed: Enclosure<N>,
    ) -> Enclosure<N> {
        match self.friction {
            Friction::Sliding(modes) => match modes.as_slice().get(contact) {
                Some(Mode::SlideForward) if speed > 0.0 => -law.slip(speed),
                Some(Mode::SlideBackward) if speed < 0.0 => law.slip(-speed),
                Some(Mode::Loose) => Enclosure::from(0.0),
                _ => {
                    self.at_rest.get_or_insert(contact);
                    Enclosure::from(0.0)
                }
            },
            Friction::Smoothed(smoothing) => smoothed(law, smoothing, speed),
            Friction::Absent => Enclosure::from(0.0),
        }
    }

    fn press<L: PressLaw<Enclosure<N>>>(
        &mut self,
        contact: usize,
        law: &L,
        gap: Enclosure<N>,
        rate: Enclosure<N>,
    ) -> Enclosure<N> {
        let nothing = Enclosure::from(0.0);
        let mode = match self.friction {
            Friction::Sliding(modes) => modes.as_slice().get(contact).copied(),
            Friction::Smoothed(_) | Friction::Absent => None,
        };
        match mode {
            Some(Mode::Open) if gap > 0.0 => return nothing,
            Some(Mode::Closed) if gap < 0.0 => {
                let force = law.force(-gap, -rate);
                if force > 0.0 {
                    return force;
                }
            }
            _ => {}
        }
        self.at_rest.get_or_insert(contact);
        nothing
    }

    fn recall<L: MemoryLaw<Enclosure<N>, S>, const S: usize>(
        &mut self,
        element: usize,
        law: &L,
        memory: [Enclosure<N>; S],
        speed: Enclosure<N>,
    ) -> Answer<Enclosure<N>, S> {
        let at_kink = &mut self.at_kink;
        law.kinks(memory, speed, |side| {
            if !side.is_positive() && !side.is_negative() {
                at_kink.get_or_insert(element);
            }
        });
        law.stops(|place, bound| {
            let inside = |gap: Enclosure<N>| gap.is_positive();
            let free = memory
                .get(place)
                .is_some_and(|z| inside(bound - *z) && inside(bound + *z));
            if !free {
                at_kink.get_or_insert(element);
            }
        });
        law.answer(memory, speed)
    }
}

/// The force of a smooth copy over all these speeds. Kernels that end at ±1, or at 4, are continued by what they are
/// there: the clamped argument has the kink.
fn smoothed<const N: usize, L: FrictionLaw<Enclosure<N>>>(
    law: &L,
    smoothing: &Smoothing,
    speed: Enclosure<N>,
) -> Enclosure<N> {
    let slip = law.slip(speed.magnitude());
    let size = Enclosure::from(smoothing.size);
    match smoothing.kernel {
        Kernel::Quartic => {
            let u = (speed / size).clamped(f64::NEG_INFINITY, 4.0);
            -bump_of(law.stick(), slip, u)
        }
        kernel @ (Kernel::Cubic | Kernel::Quintic) => {
            -slip * kernel.sign((speed * size).clamped(-1.0, 1.0))
        }
        kernel @ (Kernel::Arctan | Kernel::Tanh | Kernel::Algebraic) => {
            -slip * kernel.sign(speed * size)
        }
    }
}

//! Friction laws and the rules that decide what a contact's force is.

use crate::memory::{Answer, AnswerSlopes, MemoryLaw};
use crate::model::{Bounds, ParameterError, Unit};
use crate::press::{GapSlopes, PressLaw, pressing, pressing_slopes};
use crate::scalar::Scalar;

/// A dry friction law at given values of its parameters.
///
/// With w the relative speed of the contact and λ its force: λ = −slip(|w|) sgn w while it slides,
/// |λ| ≤ stick while it rests. Declared with `friction_law!`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a friction law without internal state",
    label = "this law has internal state, or is not declared with `friction_law!`",
    note = "a law with internal state is used as `friction F = Law {{ .. }} opposing speed with z;`, where the model declares `state z = 0.0;`"
)]
pub trait FrictionLaw<D: Scalar> {
    /// What is known about the law without its parameters.
    const INFO: &'static LawInfo;

    /// Largest magnitude of the force at rest.
    fn stick(&self) -> D;

    /// Magnitude of the force at the sliding speed `speed` > 0.
    fn slip(&self, speed: D) -> D;

    /// Both with their derivatives: by the speed, and along `along`, which holds the derivative of each field.
    fn slopes(&self, along: &Self, speed: D) -> LawSlopes<D>;

    /// Calls `visit` with the number of each parameter, in the order of declaration, and its value.
    #[inline]
    fn fields(&self, _visit: impl FnMut(usize, D)) {}
}

/// A law at one sliding speed with its derivatives; the values have the bits of the law's own functions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LawSlopes<D> {
    /// Largest magnitude of the force at rest.
    pub stick: D,
    /// Its derivative as the fields of the law move.
    pub stick_along: D,
    /// Magnitude of the force while sliding.
    pub slip: D,
    /// Its derivative with respect to the sliding speed.
    pub slip_by_speed: D,
    /// Its derivative as the fields of the law move.
    pub slip_along: D,
}

/// Decides the friction force of each contact: smoothed, sliding one way, or sticking.
///
/// A right-hand side *asks* a rule for every force; recording speeds, bounding forces, or
/// counting contacts are rules as well.
pub trait ContactRule<D: Scalar> {
    /// The force of contact number `contact`, whose relative speed is `speed`, as it stands in the equations.
    fn force<L: FrictionLaw<D>>(&mut self, contact: usize, law: &L, speed: D) -> D;

    /// The force of contact number `contact`, which presses while its `gap` is negative; without a rule, as its law says.
    #[inline]
    fn press<L: PressLaw<D>>(&mut self, _contact: usize, law: &L, gap: D, rate: D) -> D {
        pressing(law, gap, rate)
    }

    /// Force and rates of a law with internal state, number `element` among those; they are not for a rule to decide.
    #[inline]
    fn recall<L: MemoryLaw<D, S>, const S: usize>(
        &mut self,
        _element: usize,
        law: &L,
        memory: [D; S],
        speed: D,
    ) -> Answer<D, S> {
        law.answer(memory, speed)
    }
}

/// Decides the friction force of each contact together with its derivatives: a [`ContactRule`] to be differentiated.
///
/// A contact whose law reads states is asked once more for each of them.
pub trait SlopeRule {
    /// The force of contact number `contact`; `along` holds the derivatives of the law's fields in one direction.
    fn force<L: FrictionLaw<f64>>(
        &mut self,
        contact: usize,
        law: &L,
        along: &L,
        speed: f64,
    ) -> ForceSlopes;

    /// The force of contact number `contact`, which presses while its `gap` is negative, with its derivatives.
    #[inline]
    fn press<L: PressLaw<f64>>(
        &mut self,
        _contact: usize,
        law: &L,
        along: &L,
        gap: f64,
        rate: f64,
    ) -> GapSlopes {
        pressing_slopes(law, along, gap, rate)
    }

    /// Force and rates of a law with internal state, with their derivatives.
    #[inline]
    fn recall<L: MemoryLaw<f64, S>, const S: usize>(
        &mut self,
        _element: usize,
        law: &L,
        along: &L,
        memory: [f64; S],
        speed: f64,
    ) -> AnswerSlopes<f64, S> {
        law.slopes(along, memory, speed)
    }
}

/// A friction force, as it stands in the equations, and its derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForceSlopes {
    /// The force.
    pub force: f64,
    /// Its derivative with respect to the relative speed.
    pub by_speed: f64,
    /// Its derivative as the fields of the law move, the speed held.
    pub along: f64,
    /// Its derivative with respect to the design variable where the rule itself depends on it.
    pub by_design: f64,
}

/// A friction law as data.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LawInfo {
    /// Name of the struct.
    pub name: &'static str,
    /// Documentation as written.
    pub doc: &'static str,
    /// Parameters in the order of declaration.
    pub parameters: &'static [LawParameter],
    /// The right side of `stick = ...`, as written.
    pub stick: &'static str,
    /// The right side of `slip(s) = ...`, as written.
    pub slip: &'static str,
    /// The pairs of what moves, speed and fields by their names, of which the force while sliding holds more than a sum.
    pub bends: &'static [(&'static str, &'static str)],
}

impl LawInfo {
    /// Whether the force while sliding is an affine function of the speed and of these fields.
    #[must_use]
    pub fn is_straight(&self, moving: &[&str]) -> bool {
        straight(self.parameters, self.bends, moving)
    }
}

/// Whether none of these pairs moves: what is no parameter does, and of those the ones named.
pub(crate) fn straight(
    parameters: &[LawParameter],
    bends: &[(&str, &str)],
    moving: &[&str],
) -> bool {
    let stands = |name: &str| {
        let is_parameter = parameters.iter().any(|parameter| parameter.name == name);
        is_parameter && !moving.contains(&name)
    };
    bends.iter().all(|(a, b)| stands(a) || stands(b))
}

/// A parameter of a friction law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LawParameter {
    /// Name of the field.
    pub name: &'static str,
    /// Documentation as written.
    pub doc: &'static str,
    /// Unit, where one is stated.
    pub unit: Option<Unit>,
    /// Bounds that a value must keep.
    pub bounds: Bounds,
}

impl LawParameter {
    /// Checks a value against the declared bounds.
    ///
    /// # Errors
    /// The value is not finite, or out of bounds.
    pub fn check(&self, value: f64) -> Result<(), ParameterError> {
        self.bounds.check(self.name, value)
    }
}

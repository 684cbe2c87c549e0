//! Friction laws and the rules that decide what a contact's force is.

use crate::model::{Bounds, Unit};
use crate::scalar::Scalar;

/// A dry friction law at given values of its parameters.
///
/// With w the relative speed of the contact and λ its force: λ = −slip(|w|) sgn w while it slides,
/// |λ| ≤ stick while it rests. Declared with `friction_law!`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a friction law",
    label = "not declared with `friction_law!`"
)]
pub trait FrictionLaw<D: Scalar> {
    /// What is known about the law without its parameters.
    const INFO: &'static LawInfo;

    /// Largest magnitude of the force at rest.
    fn stick(&self) -> D;

    /// Magnitude of the force at the sliding speed `speed` > 0.
    fn slip(&self, speed: D) -> D;
}

/// Decides the friction force of each contact: smoothed, sliding one way, or sticking.
///
/// A right-hand side *asks* a rule for every force; recording speeds, bounding forces, or
/// counting contacts are rules as well.
pub trait ContactRule<D: Scalar> {
    /// The force of contact number `contact`, whose relative speed is `speed`, as it stands in the equations.
    fn force<L: FrictionLaw<D>>(&mut self, contact: usize, law: &L, speed: D) -> D;
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

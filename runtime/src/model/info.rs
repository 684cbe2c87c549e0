//! A declared model as data.

use super::bounds::{Bounds, ParameterError};
use super::structure::Structure;
use super::unit::Unit;
use crate::friction::LawInfo;
use crate::memory::MemoryLawInfo;
use crate::press::PressLawInfo;

/// A model as data: what it is called, what it holds, what may be asked of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModelInfo {
    /// Name of the struct.
    pub name: &'static str,
    /// Name on the command line: the struct's name in kebab case.
    pub command: &'static str,
    /// Documentation as written.
    pub doc: &'static str,
    /// States in the order of declaration.
    pub states: &'static [State],
    /// Parameters in the order of declaration.
    pub parameters: &'static [Parameter],
    /// `let` lines in the order of declaration.
    pub observables: &'static [Observable],
    /// Place among the states of the phase of a drive, if there is one: it advances at a rate of the parameters alone,
    /// and 2π more of it is the same.
    pub drive: Option<usize>,
    /// Contacts that rub in the order of declaration.
    pub contacts: &'static [Contact],
    /// Friction with internal state in the order of declaration.
    pub memories: &'static [Memory],
    /// Contacts that press in the order of declaration; among all contacts their numbers follow those that rub.
    pub presses: &'static [Press],
    /// Whether a field of a law reads a state, so that it may leave its bounds along a motion.
    pub moving: bool,
    /// Whether all rates, relative speeds, gaps and fields of laws are affine functions of the states, of the sine and
    /// cosine of the drive's phase, and of the forces; what those are its laws say.
    pub straight: bool,
    /// Structures by their modes, in the order of declaration.
    pub structures: &'static [Structure],
}

/// A state as data.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// Name as declared.
    pub name: &'static str,
    /// Documentation as written.
    pub doc: &'static str,
    /// Unit, where one is stated.
    pub unit: Option<Unit>,
    /// Value from which a motion starts if nothing else is said.
    pub start: f64,
    /// The right side of `der(name) = ...`, as written.
    pub equation: &'static str,
}

/// A parameter as data.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameter {
    /// Name as declared.
    pub name: &'static str,
    /// Documentation as written.
    pub doc: &'static str,
    /// Unit, where one is stated.
    pub unit: Option<Unit>,
    /// Value if nothing else is said.
    pub default: f64,
    /// Bounds that a value must keep.
    pub bounds: Bounds,
}

/// A `let` line as data.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Observable {
    /// Name as declared.
    pub name: &'static str,
    /// Documentation as written.
    pub doc: &'static str,
    /// Unit, where the units stated elsewhere decide it.
    pub unit: Option<Unit>,
    /// The right side, as written.
    pub formula: &'static str,
}

/// A `friction` line as data, and its law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Friction<L: 'static> {
    /// Name of the force as declared.
    pub name: &'static str,
    /// Documentation as written.
    pub doc: &'static str,
    /// Unit of the force, where one is stated.
    pub unit: Option<Unit>,
    /// The law that acts.
    pub law: &'static L,
    /// The fields of the law, as written: `limit: F_s, decay: delta`.
    pub fields: &'static str,
    /// The relative speed, as written.
    pub speed: &'static str,
    /// Unit of the relative speed, where the units stated elsewhere decide it.
    pub speed_unit: Option<Unit>,
    /// Numbers of the model's states that carry the internal states of the law, in the order of the law.
    pub states: &'static [usize],
    /// Numbers, among all contacts, of the presses that the fields of the law read.
    pub presses: &'static [usize],
    /// Names of the fields of the law that move with the states or the drive.
    pub moving: &'static [&'static str],
}

/// A `press` line as data, and its law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Press {
    /// Name of the force as declared.
    pub name: &'static str,
    /// Documentation as written.
    pub doc: &'static str,
    /// Unit of the force, where one is stated.
    pub unit: Option<Unit>,
    /// The law that acts.
    pub law: &'static PressLawInfo,
    /// The fields of the law, as written.
    pub fields: &'static str,
    /// The gap, as written.
    pub gap: &'static str,
    /// Unit of the gap, where the units stated elsewhere decide it.
    pub gap_unit: Option<Unit>,
    /// Names of the fields of the law that move with the states or the drive.
    pub moving: &'static [&'static str],
}

/// A `friction` line whose law has no internal state.
pub type Contact = Friction<LawInfo>;

/// A `friction` line whose law has internal state.
pub type Memory = Friction<MemoryLawInfo>;

impl ModelInfo {
    /// Why friction has neither an exact form nor smooth copies, where all of it has internal state.
    #[must_use]
    pub fn only_form(&self) -> Option<String> {
        let first = self.memories.first().filter(|_| !self.touches())?;
        let names: Vec<&str> = self.memories.iter().map(|memory| memory.name).collect();
        Some(format!(
            "the law of {} has internal state (`{}`): it is an ordinary differential equation, without a force at rest \
             to be solved for or smoothed, and is integrated as it is",
            names.join(", "),
            first.law.name
        ))
    }

    /// Whether the model is proven to be linear between events: in each mode of its contacts its field is an affine
    /// function of the states and of the sine and cosine of the drive's phase.
    #[must_use]
    pub fn is_linear(&self) -> bool {
        let mut contacts = self.contacts.iter();
        let mut presses = self.presses.iter();
        self.straight
            && contacts.all(|contact| contact.law.is_straight(contact.moving))
            && presses.all(|press| press.law.is_straight(press.moving))
    }

    /// Whether there are contacts with modes: that stick and slide, or press and let go.
    #[must_use]
    pub const fn touches(&self) -> bool {
        !self.contacts.is_empty() || !self.presses.is_empty()
    }

    /// Name of the force of a contact that rubs or presses, by its number.
    #[must_use]
    pub fn contact(&self, number: usize) -> Option<&'static str> {
        let rubs = self.contacts.iter().map(|contact| contact.name);
        let presses = self.presses.iter().map(|press| press.name);
        rubs.chain(presses).nth(number)
    }

    /// Whether the contact of this number presses and does not give way.
    #[must_use]
    pub fn is_rigid(&self, contact: usize) -> bool {
        let press = contact.checked_sub(self.contacts.len());
        let press = press.and_then(|press| self.presses.get(press));
        press.is_some_and(|press| press.law.is_rigid())
    }

    /// The numbers of the contacts whose friction reads the force of this press.
    pub fn rubs_under(&self, press: usize) -> impl Iterator<Item = usize> {
        let contacts = self.contacts.iter().enumerate();
        contacts.filter_map(move |(i, contact)| contact.presses.contains(&press).then_some(i))
    }

    /// Name and unit of the force of each contact, then of each press: the order in which motions report them.
    pub fn forces(&self) -> impl Iterator<Item = (&'static str, Option<Unit>)> {
        let rubs = self.contacts.iter().map(|one| (one.name, one.unit));
        rubs.chain(self.presses.iter().map(|one| (one.name, one.unit)))
    }

    /// Whether a law of the model has an internal state with stops.
    #[must_use]
    pub const fn has_stops(&self) -> bool {
        let mut i = 0;
        while i < self.memories.len() {
            if self.memories[i].law.has_stops() {
                return true;
            }
            i += 1;
        }
        false
    }

    /// Checks every parameter against its declared bounds.
    ///
    /// # Errors
    /// The first parameter that is not finite or out of its bounds.
    pub fn check(&self, values: &[f64]) -> Result<(), ParameterError> {
        for (parameter, &value) in self.parameters.iter().zip(values) {
            parameter.check(value)?;
        }
        Ok(())
    }
}

impl Parameter {
    /// Checks a value against the declared bounds.
    ///
    /// # Errors
    /// The value is not finite, or out of bounds.
    pub fn check(&self, value: f64) -> Result<(), ParameterError> {
        self.bounds.check(self.name, value)
    }
}

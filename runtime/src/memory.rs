//! Friction laws with internal state: ordinary differential equations of their own, with kinks where the speed turns.

use crate::friction::LawParameter;
use crate::model::Unit;
use crate::scalar::Scalar;

/// A friction law with `S` internal states at given values of its parameters.
///
/// With w the relative speed of the contact and z the internal states, ż = rates(z, w), and force(z, w) opposes the
/// contact: what stands in the equations is −force. There is no set-valued force, so that there is no exact form and
/// no smoothing: such a law is integrated as it is, steps ending where its formulas have kinks. Declared with
/// `friction_law!`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a friction law with {S} internal state(s)",
    label = "this many states stand after `with`, and the law declares another number",
    note = "name one state of the model after `with` for each `state` line of the law; leave `with` out if it has none"
)]
pub trait MemoryLaw<D: Scalar, const S: usize> {
    /// What is known about the law without its parameters.
    const INFO: &'static MemoryLawInfo;

    /// Rates of the internal states, and the force as it stands in the equations.
    fn answer(&self, memory: [D; S], speed: D) -> Answer<D, S>;

    /// Both with their derivatives; `along` holds the derivative of each field.
    fn slopes(&self, along: &Self, memory: [D; S], speed: D) -> AnswerSlopes<D, S>;

    /// Calls `visit` with a function that changes sign at each surface on which the law is not smooth.
    fn kinks(&self, memory: [D; S], speed: D, visit: impl FnMut(D));

    /// Calls `visit` with the number of each internal state that has stops, and the magnitude at which they stand.
    ///
    /// There the state rests while its rate points outwards, and goes on as soon as it points back.
    #[inline]
    fn stops(&self, _visit: impl FnMut(usize, D)) {}

    /// Calls `visit` with the number of each parameter, in the order of declaration, and its value.
    #[inline]
    fn fields(&self, _visit: impl FnMut(usize, D)) {}
}

/// What a law with internal state says at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Answer<D, const S: usize> {
    /// The force as it stands in the equations: against the speed.
    pub force: D,
    /// Rates of the internal states.
    pub rates: [D; S],
}

/// An [`Answer`] with its derivatives; the values have the bits of the answer itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AnswerSlopes<D, const S: usize> {
    /// The force as it stands in the equations.
    pub force: Sloped<D, S>,
    /// Rates of the internal states.
    pub rates: [Sloped<D, S>; S],
}

/// A number with its derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sloped<D, const S: usize> {
    /// The number.
    pub value: D,
    /// Its derivative with respect to the relative speed.
    pub by_speed: D,
    /// Its derivative with respect to each internal state.
    pub by_memory: [D; S],
    /// Its derivative as the fields of the law move.
    pub along: D,
}

/// A friction law with internal state as data.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MemoryLawInfo {
    /// Name of the struct.
    pub name: &'static str,
    /// Documentation as written.
    pub doc: &'static str,
    /// Parameters in the order of declaration.
    pub parameters: &'static [LawParameter],
    /// Internal states in the order of declaration.
    pub states: &'static [LawState],
    /// `let` lines in the order of declaration: name and right side, as written.
    pub abbreviations: &'static [(&'static str, &'static str)],
    /// Name of the relative speed in the formulas.
    pub speed: &'static str,
    /// The right side of `force(w) = ...`, as written.
    pub force: &'static str,
}

/// An internal state of a friction law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LawState {
    /// Name in the law.
    pub name: &'static str,
    /// Documentation as written.
    pub doc: &'static str,
    /// Unit, where one is stated.
    pub unit: Option<Unit>,
    /// The right side of `der(z) = ...`, as written.
    pub equation: &'static str,
    /// Where it stops, if it does.
    pub stop: Option<LawStop>,
}

/// The stops of an internal state, at the same distance on both sides of zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LawStop {
    /// What follows `at` in `stop z at ...`, as written.
    pub bound: &'static str,
    /// The parameters of the law that it reads.
    pub reads: &'static [&'static str],
}

impl MemoryLawInfo {
    /// The lines of the law, as written.
    #[must_use]
    pub fn lines(&self) -> Vec<String> {
        let lets = self.abbreviations.iter();
        let lets = lets.map(|(name, formula)| format!("{name} = {formula}"));
        let states = self.states.iter();
        let rates = states
            .clone()
            .map(|state| format!("der({}) = {}", state.name, state.equation));
        let stops = states.filter_map(|state| {
            let stop = state.stop?;
            Some(format!("stop {} at {}", state.name, stop.bound))
        });
        let force = format!("force({}) = {}", self.speed, self.force);
        lets.chain(rates).chain(stops).chain([force]).collect()
    }

    /// Whether an internal state has stops.
    #[must_use]
    pub const fn has_stops(&self) -> bool {
        let mut i = 0;
        while i < self.states.len() {
            if self.states[i].stop.is_some() {
                return true;
            }
            i += 1;
        }
        false
    }

    /// Whether the place of a stop depends on this parameter.
    #[must_use]
    pub const fn stops_at(&self, parameter: &str) -> bool {
        let mut i = 0;
        while i < self.states.len() {
            if let Some(stop) = &self.states[i].stop {
                let mut j = 0;
                while j < stop.reads.len() {
                    if same(stop.reads[j], parameter) {
                        return true;
                    }
                    j += 1;
                }
            }
            i += 1;
        }
        false
    }
}

/// Whether two names are one, at compile time.
pub(crate) const fn same(left: &str, right: &str) -> bool {
    let (left, right) = (left.as_bytes(), right.as_bytes());
    let mut i = 0;
    while i < left.len() && i < right.len() && left[i] == right[i] {
        i += 1;
    }
    i == left.len() && i == right.len()
}

//! What a declared model is: one right-hand side over any scalar, and itself as data.

use std::fmt;
use std::marker::PhantomData;

pub use crate::linear::Linear;

use crate::friction::{ContactRule, LawInfo, SlopeRule};
use crate::memory::MemoryLawInfo;
use crate::scalar::{Inline, Lanes, Scalar};

/// A model with `N` states: ẏ = f(y, parameters, friction forces). Written by `model!`.
pub trait Model<const N: usize>: Copy + Default + fmt::Debug + Send + Sync + 'static {
    /// The parameters over any scalar, in the order of declaration: `[D; P]`.
    type Params<D: Scalar>: Inline<D>;
    /// One value for each contact: `[T; C]`.
    type PerContact<T: Copy + Send + Sync>: Inline<T>;
    /// One value for each `let` line: `[f64; K]`.
    type Observables: Inline<f64>;
    /// Dual numbers with `N` + 1 lanes: `DualSVec64<{N + 1}>`.
    type Lanes: Lanes<N>;

    /// The model as data.
    const INFO: &'static ModelInfo;
    /// `Some(j)` in place i where the equation is `der(i) = j`, plainly another state.
    const KINEMATIC: [Option<usize>; N];
    /// Whether the equation of state i reads state j, in row i and column j (through contacts and `let` lines too).
    const SPARSITY: [[bool; N]; N];

    /// The parameters of this instance.
    fn values(&self) -> Self::Params<f64>;

    /// The instance with these parameters; they are not checked here, see [`ModelInfo::check`].
    fn from_values(values: Self::Params<f64>) -> Self;

    /// The right-hand side, each friction force asked of `contacts`.
    fn rhs<D: Scalar>(
        params: &Self::Params<D>,
        state: [D; N],
        contacts: &mut impl ContactRule<D>,
    ) -> [D; N];

    /// The same right-hand side with its derivatives, written out at compile time: `f` has the bits of [`Model::rhs`].
    ///
    /// `seeds` holds the derivative of each parameter with respect to the design variable. `entry` is given row, column
    /// and value of each entry of the Jacobian that can differ from zero, once: the work follows their number.
    fn entries(
        params: &Self::Params<f64>,
        seeds: &Self::Params<f64>,
        state: [f64; N],
        contacts: &mut impl SlopeRule,
        entry: impl FnMut(usize, usize, f64),
    ) -> Rates<N>;

    /// [`Model::entries`] with the Jacobian as a full matrix.
    // Called, it costs a small model more than its formulas do.
    #[inline(always)]
    fn linearise(
        params: &Self::Params<f64>,
        seeds: &Self::Params<f64>,
        state: [f64; N],
        contacts: &mut impl SlopeRule,
    ) -> Linear<N> {
        let mut jacobian = [[0.0; N]; N];
        let entry = |row: usize, column: usize, slope| jacobian[row][column] = slope;
        let Rates { f, design } = Self::entries(params, seeds, state, contacts, entry);
        Linear {
            f,
            jacobian,
            design,
        }
    }

    /// The values of the `let` lines.
    fn observables(
        params: &Self::Params<f64>,
        state: [f64; N],
        contacts: &mut impl ContactRule<f64>,
    ) -> Self::Observables;
}

/// A right-hand side and its derivative with respect to the design variable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rates<const N: usize> {
    /// f.
    pub f: [f64; N],
    /// ∂f/∂r.
    pub design: [f64; N],
}

/// Names one parameter of one model: a handle such as `BeltOscillator::v_dr`.
pub struct ParamId<M> {
    /// Place of the parameter in the order of declaration.
    pub index: usize,
    model: PhantomData<fn() -> M>,
}

impl<M> ParamId<M> {
    /// The parameter in this place; called by generated code.
    #[must_use]
    pub const fn new(index: usize) -> Self {
        Self {
            index,
            model: PhantomData,
        }
    }
}

impl<M> Clone for ParamId<M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M> Copy for ParamId<M> {}

impl<M> fmt::Debug for ParamId<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "ParamId({})", self.index)
    }
}

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
    /// Contacts in the order of declaration.
    pub contacts: &'static [Contact],
    /// Friction with internal state in the order of declaration.
    pub memories: &'static [Memory],
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

/// A `friction` line as data.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Name of the force as declared.
    pub name: &'static str,
    /// Documentation as written.
    pub doc: &'static str,
    /// Unit of the force, where one is stated.
    pub unit: Option<Unit>,
    /// The law that acts.
    pub law: &'static LawInfo,
    /// The fields of the law, as written: `limit: F_s, decay: delta`.
    pub fields: &'static str,
    /// The relative speed, as written.
    pub speed: &'static str,
    /// Unit of the relative speed, where the units stated elsewhere decide it.
    pub speed_unit: Option<Unit>,
}

/// A `friction` line whose law has internal state, as data.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Memory {
    /// Name of the force as declared.
    pub name: &'static str,
    /// Documentation as written.
    pub doc: &'static str,
    /// Unit of the force, where one is stated.
    pub unit: Option<Unit>,
    /// The law that acts.
    pub law: &'static MemoryLawInfo,
    /// The fields of the law, as written.
    pub fields: &'static str,
    /// The relative speed, as written.
    pub speed: &'static str,
    /// Numbers of the model's states that carry the internal states of the law, in the order of the law.
    pub states: &'static [usize],
}

/// A unit: its text, and its exponents of m, kg, s, A, K, mol, cd.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Unit {
    /// As written, for instance `N/m`; `1` for a dimensionless quantity.
    pub text: &'static str,
    /// Exponents of the SI base units m, kg, s, A, K, mol, cd.
    pub dimension: [i8; 7],
}

/// An interval for a parameter, each end open, closed or absent.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Bounds {
    /// Lower end.
    pub lower: Option<Bound>,
    /// Upper end.
    pub upper: Option<Bound>,
}

/// One end of an interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bound {
    /// Where the interval ends.
    pub value: f64,
    /// Whether the end belongs to it.
    pub inclusive: bool,
}

impl Bounds {
    /// No bound at all.
    pub const NONE: Self = Self {
        lower: None,
        upper: None,
    };

    /// Whether `value` is finite and inside.
    #[must_use]
    pub fn contain(&self, value: f64) -> bool {
        let above = |b: Bound| value > b.value || (b.inclusive && value == b.value);
        let below = |b: Bound| value < b.value || (b.inclusive && value == b.value);
        value.is_finite() && self.lower.is_none_or(above) && self.upper.is_none_or(below)
    }

    /// Checks a value of the parameter `name`.
    pub(crate) fn check(&self, name: &'static str, value: f64) -> Result<(), ParameterError> {
        if !value.is_finite() {
            return Err(ParameterError::NotFinite { name, value });
        }
        if !within_reach(value) {
            return Err(ParameterError::OutOfReach { name, value });
        }
        if !self.contain(value) {
            let bound = self.describe(name);
            return Err(ParameterError::OutOfBounds { name, value, bound });
        }
        Ok(())
    }

    /// The bounds as a user writes them, for instance `0 <= zeta < 1`; empty if there are none.
    #[must_use]
    pub fn describe(&self, name: &str) -> String {
        let sign = |inclusive| if inclusive { "=" } else { "" };
        match (self.lower, self.upper) {
            (None, None) => String::new(),
            (Some(l), None) => format!("{name} >{} {}", sign(l.inclusive), l.value),
            (None, Some(u)) => format!("{name} <{} {}", sign(u.inclusive), u.value),
            (Some(l), Some(u)) => {
                let (a, b) = (sign(l.inclusive), sign(u.inclusive));
                format!("{} <{a} {name} <{b} {}", l.value, u.value)
            }
        }
    }
}

/// A value that a parameter must not have.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ParameterError {
    /// Not a number, or infinite.
    #[error("{name} = {value} is not a finite number")]
    NotFinite {
        /// The parameter.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// So large or so small that its square is no number.
    #[error("{name} = {value:e} is out of reach: magnitudes lie between 1e-100 and 1e100")]
    OutOfReach {
        /// The parameter.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// Outside the declared bounds.
    #[error("{name} = {value} breaks its declared bound {bound}")]
    OutOfBounds {
        /// The parameter.
        name: &'static str,
        /// Its value.
        value: f64,
        /// The bounds as written.
        bound: String,
    },
}

/// Whether a number is zero, or such that its square and a few more factors are numbers too.
#[must_use]
pub fn within_reach(value: f64) -> bool {
    value == 0.0 || (1e-100..=1e100).contains(&value.abs())
}

impl ModelInfo {
    /// Why friction has neither an exact form nor smooth copies, where all of it has internal state.
    #[must_use]
    pub fn only_form(&self) -> Option<String> {
        let first = self.memories.first().filter(|_| self.contacts.is_empty())?;
        let names: Vec<&str> = self.memories.iter().map(|memory| memory.name).collect();
        Some(format!(
            "the law of {} has internal state (`{}`): it is an ordinary differential equation, without a force at rest \
             to be solved for or smoothed, and is integrated as it is",
            names.join(", "),
            first.law.name
        ))
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

//! What a declared model is: one right-hand side over any scalar, and itself as data.

mod bounds;
mod contact_id;
mod culprit;
mod formula;
mod info;
mod structure;
mod unit;
mod values;

pub use crate::linear::Linear;
pub use bounds::{Bound, Bounds, ParameterError, within_reach};
pub use contact_id::{ContactId, listed};
pub use info::{Contact, Friction, Memory, ModelInfo, Observable, Parameter, Press, State};
pub use structure::{Structure, StructureMode, StructurePoint};
pub use unit::Unit;
pub use values::{Values, brief};

use std::fmt;
use std::marker::PhantomData;

use crate::friction::{ContactRule, SlopeRule};
use crate::scalar::{Inline, Lanes, Scalar};

/// A model with `N` states: ẏ = f(y, parameters, friction forces). Written by `model!`.
pub trait Model<const N: usize>: Copy + Default + fmt::Debug + Send + Sync + 'static {
    /// The parameters over any scalar, in the order of declaration: `[D; P]`.
    type Params<D: Scalar>: Inline<D>;
    /// One value for each contact that rubs, and after those for each that presses: `[T; C]`.
    type PerContact<T: Copy + Send + Sync>: Inline<T>;
    /// One value for each `let` line: `[f64; K]`.
    type Observables: Inline<f64>;
    /// Dual numbers with `N` + 1 lanes: `DualSVec64<{N + 1}>`, or [`Wide`](crate::scalar::Wide) ones for many states.
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

//! Gaps that stay closed: what takes positions back to them.

use num_dual::Dual64;

use super::affine::{Square, input, speed_rates};
use super::mode::{Mode, Modes};
use super::rule::Branches;
use super::solve::solve;
use super::system::ExactSystem;
use crate::model::Model;
use crate::scalar::{Inline, filled, mapped};

/// How gaps of presses at rest are closed at one state: along C = J B, the way in which positions go on after an impulse.
///
/// A gap is a formula of positions, so that an impulse B leaves it as it is, and g_y C = G is what B does to its rate.
pub(crate) struct Closed<M: Model<N>, const N: usize> {
    modes: Modes<M, N>,
    directions: M::PerContact<[f64; N]>,
    matrix: Square<M, f64, N>,
}

impl<M: Model<N>, const N: usize> Closed<M, N> {
    /// At a state; `None` if the gaps are not independent there.
    pub(crate) fn new(
        system: &ExactSystem<M, N>,
        state: &[f64; N],
        modes: &Modes<M, N>,
    ) -> Option<Self> {
        let open = Modes::<M, N>::held();
        let still = Modes::<M, N>::from_fn(|i| match modes.as_slice()[i] {
            mode if mode.is_of_press() => mode,
            _ => Mode::Loose,
        });
        let mut directions: M::PerContact<[f64; N]> = Inline::from_fn(|_| [0.0; N]);
        let mut matrix: Square<M, f64, N> = Inline::from_fn(|_| Inline::from_fn(|_| 0.0));
        for column in modes.resting() {
            let push = input::<M, f64, N>(&system.plain, state, &still, column);
            let moving = filled(|i| Dual64::new(state[i], push[i]));
            let mut rule = Branches::<M, Dual64, N>::free(still.as_slice());
            let field = M::rhs(&system.directional, moving, &mut rule);
            let way = mapped(&field, |f| f.eps);
            let gaps = speed_rates::<M, f64, N>(&system.plain, state, &open, &way);
            directions.as_mut()[column] = way;
            for row in modes.resting() {
                matrix.as_mut()[row].as_mut()[column] = gaps.as_ref()[row];
            }
        }
        let closed = Self {
            modes: *modes,
            directions,
            matrix,
        };
        closed.steps(Inline::from_fn(|_| 0.0)).map(|_| closed)
    }

    /// How far to go along each direction; `None` if the gaps are not independent.
    fn steps(&self, mut gaps: M::PerContact<f64>) -> Option<M::PerContact<f64>> {
        let (mut rows, resting) = (self.matrix, self.modes.which(|mode| mode == Mode::Rest));
        solve(rows.as_mut(), gaps.as_mut(), resting.as_ref())?;
        Some(gaps)
    }

    /// The change of the state that changes the gaps of presses at rest by these amounts.
    pub(crate) fn correction(&self, gaps: &M::PerContact<f64>) -> [f64; N] {
        let mut change = [0.0; N];
        let Some(steps) = self.steps(*gaps) else {
            return change;
        };
        for press in self.modes.resting() {
            let step = steps.as_ref()[press];
            for (c, way) in change.iter_mut().zip(&self.directions.as_ref()[press]) {
                *c += step * way;
            }
        }
        change
    }
}

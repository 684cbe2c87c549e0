//! Gaps that stay closed: what takes positions back to them.

use num_dual::Dual64;

use super::affine::{Square, input, speed_rates};
use super::mode::{Mode, Modes};
use super::rule::Branches;
use super::solve::solve;
use super::system::ExactSystem;
use crate::model::Model;
use crate::scalar::Inline;

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
            let moving = crate::scalar::filled(|i| Dual64::new(state[i], push[i]));
            let mut rule = Branches::<M, Dual64, N>::free(still.as_slice());
            let way = M::rhs(&system.directional, moving, &mut rule).map(|f| f.eps);
            let gaps = speed_rates::<M, f64, N>(&system.plain, state, &open, &way);
            directions.as_mut()[column] = way;
            for row in modes.resting() {
                matrix.as_mut()[row].as_mut()[column] = gaps.as_ref()[row];
            }
        }
        let resting = |i: usize| modes.as_slice()[i] == Mode::Rest;
        solve::<M, f64, N>(matrix, Inline::from_fn(|_| 0.0), resting)?;
        Some(Self {
            modes: *modes,
            directions,
            matrix,
        })
    }

    /// The change of the state that changes the gaps of presses at rest by these amounts.
    pub(crate) fn correction(&self, gaps: &M::PerContact<f64>) -> [f64; N] {
        let resting = |i: usize| self.modes.as_slice()[i] == Mode::Rest;
        let mut change = [0.0; N];
        let Some(steps) = solve::<M, f64, N>(self.matrix, *gaps, resting) else {
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

//! Internal states on their stops.

use super::SmoothField;
use crate::field::{Field, Settled, Stops};
use crate::model::Model;

impl<M: Model<N>, const N: usize> SmoothField<M, N> {
    /// Whether any internal state has stops: what is asked of others costs nothing.
    pub(crate) const STOPS: bool = M::INFO.has_stops();

    /// The stops with the modes of this field.
    pub(crate) fn stops(&self) -> &Stops<N> {
        &self.stops
    }

    /// The field while these states rest.
    pub(crate) fn resting(mut self, stops: Stops<N>) -> Self {
        self.stops = stops;
        self
    }

    /// f, were every state free.
    #[inline]
    pub(super) fn free(&self, y: &[f64; N]) -> [f64; N] {
        M::rhs(&self.values, *y, &mut { self.rule })
    }

    /// The number of the guard that is corner number `index`, if it is one.
    #[inline]
    pub(super) fn guard_number(&self, index: usize) -> Option<usize> {
        if !Self::STOPS || index >= self.corners {
            return None;
        }
        index.checked_sub(self.corners - self.stops.guards())
    }

    /// The modes with which a motion begins at `y`, which is put between its stops.
    pub(crate) fn settled(&self, y: &mut [f64; N]) -> Settled<N> {
        self.stops.settled(y, |stops, y, state| {
            let linear = self.resting(*stops).linearise(y);
            let rate = linear.f[state];
            if rate != 0.0 {
                return rate;
            }
            // At a turning point the next derivative decides.
            let slopes = linear.jacobian[state].iter().zip(&linear.f);
            slopes.map(|(slope, rate)| slope * rate).sum()
        })
    }

    /// The modes after corner number `index` was met at `y`, if it is a guard.
    pub(crate) fn switched(&self, y: &mut [f64; N], index: usize) -> Option<Settled<N>> {
        let guard = self.guard_number(index)?;
        let rates = self.free(y);
        Some(self.stops.switched(y, guard, &rates))
    }
}

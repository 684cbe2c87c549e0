//! A periodic orbit with everything that is known of it.

use nalgebra::DVector;

use super::problem::Shot;
use crate::bifurcation::{Floquet, floquet};
use crate::field::Work;
use crate::flow::{Flow, Place, Segment};

/// A periodic orbit.
#[derive(Debug, Clone)]
pub struct Orbit<const N: usize, Mode> {
    /// The design variable.
    pub r: f64,
    /// Its start: on the default section, the first state least.
    pub place: Place<N, Mode>,
    /// Its minimal period.
    pub period: f64,
    /// Largest value of each state, from the dense motion.
    pub max: [f64; N],
    /// Smallest value of each state.
    pub min: [f64; N],
    /// Crossings of the section der(first state) = 0, upwards, in one period.
    pub period_count: usize,
    /// Stability.
    pub floquet: Floquet,
    /// Norm of the shooting residual, relative to the extents of the states.
    pub residual: f64,
    /// Estimated relative error of period and extrema.
    pub error_estimate: f64,
    /// Stretches in constant mode.
    pub segments: Vec<Segment<Mode>>,
    /// Work of finding it.
    pub work: Work,
}

/// Whether two times are the same instant of a period.
const INSTANT: f64 = 1e-6;

impl<const N: usize, Mode: Copy + PartialEq> Orbit<N, Mode> {
    /// Reads an orbit off its converged shot.
    pub(crate) fn read<F: Flow<N, Mode = Mode>>(
        shot: &Shot<N, Mode>,
        r: f64,
        residual: f64,
        accuracy: f64,
        work: Work,
    ) -> Self {
        let (min, max) = shot.extent();
        let segments: Vec<Segment<Mode>> = shot
            .passages
            .iter()
            .flat_map(|p| p.segments.clone())
            .collect();
        let zeros = segments
            .iter()
            .map(|segment| F::sticking(&segment.mode))
            .max()
            .unwrap_or(0);
        let (monodromy, trace) = shot.monodromy();
        let trace = (segments.len() == shot.passages.len()).then_some(trace);
        let floquet = floquet(&monodromy, &shot.velocity.f, trace, zeros, accuracy);
        Self {
            r,
            place: shot.start,
            period: shot.period,
            max,
            min,
            period_count: shot.minima().count().max(1),
            floquet,
            residual,
            error_estimate: accuracy.max(residual),
            segments,
            work,
        }
    }

    /// The same orbit, its start and period moved by Newton's last, negligible correction.
    pub(crate) fn at(mut self, z: &DVector<f64>) -> Self {
        self.place.state = std::array::from_fn(|j| z[j]);
        self.period = z[z.len() - 1];
        self
    }

    /// Largest magnitude of each state.
    #[must_use]
    pub fn max_abs(&self) -> [f64; N] {
        std::array::from_fn(|j| self.max[j].abs().max(self.min[j].abs()))
    }
}

impl<const N: usize, Mode: Copy> Shot<N, Mode> {
    /// Φ once around, and ∫ tr J.
    pub(crate) fn monodromy(&self) -> ([[f64; N]; N], f64) {
        let mut phi: [[f64; N]; N] =
            std::array::from_fn(|i| std::array::from_fn(|j| f64::from(i == j)));
        let mut trace = 0.0;
        for derivatives in self
            .passages
            .iter()
            .filter_map(|passage| passage.derivatives.as_ref())
        {
            let step = &derivatives.state;
            phi = std::array::from_fn(|i| {
                std::array::from_fn(|j| (0..N).map(|k| step[i][k] * phi[k][j]).sum())
            });
            trace += derivatives.trace;
        }
        (phi, trace)
    }

    /// Time and state of each minimum of the first state in [0, T), the start included once if it is one.
    pub(crate) fn minima(&self) -> impl Iterator<Item = (f64, [f64; N])> + '_ {
        let share = self.period / self.passages.len().max(1) as f64;
        let near = INSTANT * self.period;
        let all = self
            .passages
            .iter()
            .enumerate()
            .flat_map(move |(i, passage)| {
                let minima = passage
                    .extrema
                    .iter()
                    .filter(|e| e.index == 0 && !e.maximum);
                minima.map(move |e| (i as f64 * share + e.time, e.state))
            });
        let inside = all.filter(move |(time, _)| *time > near && *time < self.period - near);
        let slope = self.velocity.f[0] * self.period;
        let size = (0..N)
            .map(|j| (self.velocity.jacobian[0][j] * self.velocity.f[j]).abs())
            .sum::<f64>();
        let on_section = slope.abs() <= near * size * self.period;
        let bend: f64 = (0..N)
            .map(|j| self.velocity.jacobian[0][j] * self.velocity.f[j])
            .sum();
        let start = (on_section && bend > 0.0).then_some((0.0, self.start.state));
        start.into_iter().chain(inside)
    }
}

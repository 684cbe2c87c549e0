//! A periodic orbit with everything that is known of it.

use std::f64::consts::TAU;

use nalgebra::DVector;

use super::problem::{Shot, half_extents};
use crate::bifurcation::{Floquet, floquet};
use crate::field::Work;
use crate::flow::{Event, Factor, Family, Flow, Place, Segment};

/// A periodic orbit.
#[derive(Debug, Clone)]
pub struct Orbit<const N: usize, Mode> {
    /// The design variable.
    pub r: f64,
    /// Its start: on the default section, the first state least; with a drive, where its phase begins.
    pub place: Place<N, Mode>,
    /// Its minimal period.
    pub period: f64,
    /// Largest value of each state, from the dense motion.
    pub max: [f64; N],
    /// Smallest value of each state.
    pub min: [f64; N],
    /// Crossings of the section der(first state) = 0, upwards, in one period; with a drive, how often that turns.
    pub period_count: usize,
    /// Stability.
    pub floquet: Floquet,
    /// Norm of the shooting residual, relative to the extents of the states.
    pub residual: f64,
    /// Estimated relative error of period and extrema.
    pub error_estimate: f64,
    /// Stretches in constant mode.
    pub segments: Vec<Segment<Mode>>,
    /// What happened at the contacts, or nearly did; nothing for a smooth system.
    pub events: Vec<Event<N>>,
    /// Its points on the default section, where the first state is least, in the order of time.
    pub section: Vec<[f64; N]>,
    /// Where it stands on its branch.
    pub heading: Heading<N, Mode>,
    /// Work of finding it.
    pub work: Work,
}

/// Where an orbit stands on its branch, so that another branch can set out from there.
#[derive(Debug, Clone, PartialEq)]
pub struct Heading<const N: usize, Mode> {
    /// Where shooting starts: not always on the section.
    pub start: Place<N, Mode>,
    /// Unit tangent of the branch in scaled coordinates (start, period, r); `None` off any branch, or
    /// where shooting has several segments.
    pub tangent: Option<DVector<f64>>,
    /// r-component of the unit tangent; 1 off any branch.
    pub slope: f64,
}

impl<const N: usize, Mode> Heading<N, Mode> {
    /// Takes the tangent of the branch.
    pub(crate) fn follow(&mut self, tangent: &DVector<f64>) {
        self.slope = tangent[tangent.len() - 1];
        self.tangent = (tangent.len() == N + 2).then(|| tangent.clone());
    }
}

/// A converged solution of the shooting equations.
pub(crate) struct Solution<'a, const N: usize, Mode> {
    pub(crate) shot: &'a Shot<N, Mode>,
    pub(crate) z: &'a DVector<f64>,
    pub(crate) r: f64,
    pub(crate) residual: f64,
}

/// The start of the orbit if it lies on the default section; else the lowest of its minima of the first state.
fn section_place<F: Family<N>, const N: usize>(
    family: &F,
    solution: &Solution<'_, N, <F::Flow as Flow<N>>::Mode>,
) -> Place<N, <F::Flow as Flow<N>>::Mode> {
    let (shot, z) = (solution.shot, solution.z);
    let start = Place {
        state: std::array::from_fn(|j| z[j]),
        mode: shot.start.mode,
    };
    if shot.starts_on_section() {
        return start;
    }
    let lowest = shot.minima().min_by(|a, b| a.1[0].total_cmp(&b.1[0]));
    let place = lowest.and_then(|(_, state)| family.at(solution.r).ok()?.place(state).ok());
    place.unwrap_or(start)
}

/// Whether two times are the same instant of a period.
const INSTANT: f64 = 1e-6;

impl<const N: usize, Mode: Copy + PartialEq> Orbit<N, Mode> {
    /// Reads an orbit off its converged shot.
    pub(crate) fn read<F>(
        family: &F,
        solution: Solution<'_, N, Mode>,
        accuracy: f64,
        work: Work,
    ) -> Self
    where
        F: Family<N>,
        F::Flow: Flow<N, Mode = Mode>,
    {
        let Solution {
            shot,
            z,
            r,
            residual,
        } = solution;
        let (min, max) = shot.extent();
        let passages = shot.passages.iter();
        let segments: Vec<Segment<Mode>> = passages
            .clone()
            .flat_map(|passage| passage.segments.clone())
            .collect();
        let sticking = |segment: &Segment<Mode>| F::Flow::sticking(&segment.mode);
        let zeros = segments.iter().map(sticking).max().unwrap_or(0);
        let derivatives = passages.clone().filter_map(|p| p.derivatives.as_ref());
        let zeros = zeros.max(derivatives.map(|d| d.lost).max().unwrap_or(0));
        let (monodromy, trace) = shot.monodromy();
        let trace = (segments.len() == shot.passages.len()).then_some(trace);
        Self {
            r,
            place: section_place(family, &solution),
            period: z[z.len() - 1],
            max,
            min,
            period_count: shot.minima().count().max(1),
            floquet: floquet(
                &monodromy,
                &shot.velocity.f,
                trace,
                zeros,
                &shot.factors(),
                accuracy,
            ),
            residual,
            error_estimate: accuracy.max(residual),
            events: passages
                .flat_map(|passage| passage.events.clone())
                .collect(),
            segments,
            section: shot.minima().map(|(_, state)| state).collect(),
            heading: Heading {
                start: Place {
                    state: std::array::from_fn(|j| z[j]),
                    mode: shot.start.mode,
                },
                tangent: None,
                slope: 1.0,
            },
            work,
        }
    }

    /// Half the extent of each state; 1 for one that rests, and so has none to be measured against.
    #[must_use]
    pub fn magnitude(&self) -> [f64; N] {
        half_extents(&self.min, &self.max, &[1.0; N])
    }

    /// Largest magnitude of each state.
    #[must_use]
    pub fn max_abs(&self) -> [f64; N] {
        std::array::from_fn(|j| self.max[j].abs().max(self.min[j].abs()))
    }
}

impl<const N: usize, Mode: Copy> Shot<N, Mode> {
    /// The factors of Φ once around, if they were wanted.
    fn factors(&self) -> Vec<Factor<N>> {
        let derivatives = self
            .passages
            .iter()
            .filter_map(|passage| passage.derivatives.as_ref());
        derivatives
            .flat_map(|derivatives| derivatives.factors.iter().copied())
            .collect()
    }

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

    /// Time and state of each minimum of the first state in [0, T), the start included once if it is one; with a drive,
    /// of each beginning of its phase.
    pub(crate) fn minima(&self) -> impl Iterator<Item = (f64, [f64; N])> + '_ {
        let share = self.period / self.passages.len().max(1) as f64;
        let near = INSTANT * self.period;
        let section = self.drive.unwrap_or(0);
        let all = self
            .passages
            .iter()
            .enumerate()
            .flat_map(move |(i, passage)| {
                let minima = passage
                    .extrema
                    .iter()
                    .filter(move |e| e.index == section && !e.maximum);
                minima.map(move |e| (i as f64 * share + e.time, e.state))
            });
        let inside = all.filter(move |(time, _)| *time > near && *time < self.period - near);
        let start = self.starts_on_section().then_some((0.0, self.start.state));
        start.into_iter().chain(inside)
    }

    /// Whether the first state is least at the start; with a drive, whether its phase begins there.
    fn starts_on_section(&self) -> bool {
        if let Some(phase) = self.drive {
            let turns = self.start.state[phase] / TAU;
            return (turns - turns.round()).abs() <= INSTANT;
        }
        let terms = (0..N).map(|j| self.velocity.jacobian[0][j] * self.velocity.f[j]);
        let (bend, size) = terms.fold((0.0, 0.0), |(sum, size), term: f64| {
            (sum + term, size + term.abs())
        });
        self.velocity.f[0].abs() <= INSTANT * self.period * size && bend > 0.0
    }
}

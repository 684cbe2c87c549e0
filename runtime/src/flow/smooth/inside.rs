//! The inside of explicit and implicit steps, where extrema are looked for.

use crate::field::{Field, Linear};
use crate::flow::extrema::Inside;
use crate::integrate::event::Bernstein;
use crate::integrate::explicit::Stepper;
use crate::integrate::{Accepted, Carried, Dense, Radau};
use crate::scalar::mapped;

/// An explicit step.
pub(super) struct Explicit<'a, 's, F, V, const N: usize> {
    pub(super) field: &'a F,
    pub(super) step: &'a mut Stepper<'s, F, V, N>,
    pub(super) dense: Dense<N>,
    pub(super) time: f64,
}

impl<F: Field<N>, V: Carried<N>, const N: usize> Inside<N> for Explicit<'_, '_, F, V, N> {
    fn span(&self) -> (f64, f64) {
        (self.time, self.dense.length())
    }

    fn path(&self, index: usize) -> Bernstein {
        self.dense.component(index)
    }

    fn probe(&mut self, theta: f64) -> Option<([f64; N], Linear<N>)> {
        let state = self.step.step_map(theta * self.dense.length());
        Some((state, self.field.linearise(&state)))
    }
}

/// An implicit step.
pub(super) struct Implicit<'a, 'f, F, const N: usize, const S: usize> {
    radau: &'a mut Radau<'f, F, N, S>,
    step: &'a Accepted<N, S>,
    time: f64,
    /// States at the nodes of a polynomial.
    nodes: [[f64; N]; 8],
}

impl<'a, 'f, F: Field<N>, const N: usize, const S: usize> Implicit<'a, 'f, F, N, S> {
    pub(super) fn new(
        radau: &'a mut Radau<'f, F, N, S>,
        step: &'a Accepted<N, S>,
        time: f64,
    ) -> Self {
        Self {
            radau,
            step,
            time,
            nodes: Bernstein::nodes().map(|theta| step.inside(theta)),
        }
    }
}

impl<F: Field<N>, const N: usize, const S: usize> Inside<N> for Implicit<'_, '_, F, N, S> {
    fn span(&self) -> (f64, f64) {
        (self.time, self.step.step)
    }

    fn path(&self, index: usize) -> Bernstein {
        Bernstein::interpolate(&mapped(&self.nodes, |state| state[index]))
    }

    fn probe(&mut self, theta: f64) -> Option<([f64; N], Linear<N>)> {
        self.radau.probe(self.step, theta)
    }
}

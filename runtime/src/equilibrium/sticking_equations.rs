//! The equations of equilibria at which contacts stick: each row of norm 1, by states in their sizes.

use nalgebra::{DMatrix, DVector};

use super::resting::held;
use super::sizes::sizes;
use crate::field::exact::Mode;
use crate::linear::svd;
use crate::motion::{Contacts, Flow, Modes, Place, Row};

const ITERATIONS: usize = 60;
/// Equations are fulfilled to this, relative to their terms.
const FULFILLED: f64 = 1e-11;
/// Singular values below this share of the largest are zero.
pub(super) const RANK: f64 = 1e-9;

/// Where sticking equilibria are looked for.
pub(super) struct Sought<'a> {
    pub(super) flow: &'a dyn Flow,
    pub(super) modes: &'a Modes,
    /// What states are measured in.
    pub(super) sizes: Vec<f64>,
}

impl<'a> Sought<'a> {
    /// Where states are about as large as here.
    pub(super) fn new(flow: &'a dyn Flow, modes: &'a Modes, near: &[f64]) -> Option<Self> {
        let mut sought = Self {
            flow,
            modes,
            sizes: Vec::new(),
        };
        sought.sizes = sizes(near, &sought.at(near)?.jacobian);
        Some(sought)
    }
}

impl Sought<'_> {
    pub(super) fn place(&self, state: &[f64]) -> Place {
        Place {
            state: state.to_vec(),
            modes: self.modes.clone(),
        }
    }

    pub(super) fn at(&self, state: &[f64]) -> Option<Contacts> {
        self.flow.contacts(&self.place(state)).ok()
    }

    /// f = 0, w = 0 of the sticking contacts, closed gaps, and, for signs given, forces at the limit: as a matrix of slopes by
    /// states in their sizes, each row of norm 1, and what is missing.
    pub(super) fn equations(
        &self,
        state: &[f64],
        signs: &[f64],
    ) -> Option<(DMatrix<f64>, DVector<f64>)> {
        let Contacts { f, jacobian, all } = self.at(state)?;
        let stuck = || {
            let pairs = self.modes.iter().zip(&all);
            pairs.filter_map(|(mode, contact)| (*mode == Mode::Stick).then_some(contact))
        };
        let loaded = stuck().zip(signs);
        let limits = loaded.map(|(contact, sign)| limit(&contact.force, &contact.stick, *sign));
        let held = held(self.flow, &self.place(state)).ok()?;
        let more: Vec<Row> = held.into_iter().chain(limits).collect();
        let order = f.len();
        let mut matrix = DMatrix::from_fn(order + more.len(), order, |i, j| {
            let slope = match i.checked_sub(order) {
                None => jacobian[(i, j)],
                Some(i) => more[i].slopes[j],
            };
            slope * self.sizes[j]
        });
        let values = f.iter().copied().chain(more.iter().map(|row| row.value));
        let mut missing = DVector::from_vec(values.map(|value| -value).collect());
        for (mut row, missing) in matrix.row_iter_mut().zip(missing.iter_mut()) {
            let norm = row.norm();
            if norm > 0.0 {
                row /= norm;
                *missing /= norm;
            }
        }
        Some((matrix, missing))
    }

    /// Gauss and Newton's shortest steps; `None` unless every equation is fulfilled in the end.
    pub(super) fn solve(&self, start: &[f64], signs: &[f64]) -> Option<Vec<f64>> {
        let mut state = start.to_vec();
        for _ in 0..ITERATIONS {
            let (matrix, right) = self.equations(&state, signs)?;
            if !matrix.iter().chain(&right).all(|number| number.is_finite()) {
                return None;
            }
            let done = matrix.row_iter().zip(&right).all(|(row, right)| {
                let states = row.iter().zip(state.iter().zip(&self.sizes));
                let term = |(g, (y, size)): (&f64, (&f64, &f64))| {
                    g.abs() * y.abs().max(size.min(1.0)) / size
                };
                right.abs() <= FULFILLED * states.map(term).sum::<f64>()
            });
            if done {
                return Some(state);
            }
            let svd = svd(matrix)?;
            let mut step = svd.solve(&right, RANK * svd.singular_values.max()).ok()?;
            let scaled = step.iter_mut().zip(&self.sizes);
            scaled.for_each(|(change, size)| *change *= size);
            // What cannot be fulfilled is as near to it as it gets.
            let mut changes = state.iter().zip(&step);
            if changes.all(|(y, change)| change.abs() <= FULFILLED * y.abs()) {
                return None;
            }
            for (y, change) in state.iter_mut().zip(&step) {
                *y += change;
            }
        }
        None
    }
}

/// λ − sign · stick.
fn limit(force: &Row, stick: &Row, sign: f64) -> Row {
    let slopes = force.slopes.iter().zip(&stick.slopes);
    Row {
        value: force.value - stick.value * sign,
        slopes: slopes.map(|(force, stick)| force - stick * sign).collect(),
        design: force.design - stick.design * sign,
    }
}

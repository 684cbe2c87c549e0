//! Equilibria at which contacts stick: sets of states, bounded by what friction can hold.

use nalgebra::{DMatrix, DVector};

use super::Spectrum;
use crate::field::exact::{ExactSystem, Mode, Modes};
use crate::flow::FlowError;
use crate::model::Model;
use crate::scalar::Lanes;
use num_dual::DualStruct;

const ITERATIONS: usize = 60;
/// Equations are fulfilled to this, relative to their terms.
const FULFILLED: f64 = 1e-11;
/// Singular values below this share of the largest are zero.
const RANK: f64 = 1e-9;
/// Contacts whose corners are tried one by one.
const CORNERS: usize = 6;

/// All equilibria in one mode in which contacts stick.
#[derive(Clone, PartialEq)]
pub struct StickingSet<M: Model<N>, const N: usize> {
    /// The mode of each contact.
    pub mode: Modes<M, N>,
    /// How many directions it has: 0 for a single state, 1 for an interval.
    pub dimension: usize,
    /// A state in it.
    pub state: [f64; N],
    /// Smallest value of each state at its corners, where every sticking contact is at its limit.
    pub low: [f64; N],
    /// Largest value of each state there.
    pub high: [f64; N],
    /// Eigenvalues for motions that leave the set while the contacts stick.
    pub spectrum: Spectrum,
}

/// The sticking equilibria of `model`, looked for from each of `starts` in each of `modes`; a mode is reported once.
///
/// # Errors
/// A parameter is outside its bounds, or a friction force does not oppose its speed.
pub fn sticking_sets<M: Model<N>, const N: usize>(
    model: &M,
    starts: &[[f64; N]],
    modes: &[Modes<M, N>],
) -> Result<Vec<StickingSet<M, N>>, FlowError> {
    M::INFO.check(model.values().as_ref())?;
    let system = ExactSystem::new(model, None);
    system.check()?;
    let sets = modes.iter().filter_map(|mode| {
        let sought = Sought {
            system: &system,
            mode: *mode,
        };
        starts.iter().find_map(|start| sought.set(*start))
    });
    Ok(sets.collect())
}

struct Sought<'a, M: Model<N>, const N: usize> {
    system: &'a ExactSystem<M, N>,
    mode: Modes<M, N>,
}

/// Equations with their gradients, and what each is measured against.
type Equation<const N: usize> = (f64, [f64; N]);

impl<M: Model<N>, const N: usize> Sought<'_, M, N> {
    fn set(&self, start: [f64; N]) -> Option<StickingSet<M, N>> {
        let sticking = self.mode.sticking().count();
        let inside = self.solve(start, &[])?;
        let equations = self.equations(&inside, &[])?;
        let matrix = DMatrix::from_fn(equations.len(), N, |i, j| equations[i].1[j]);
        let values = matrix.singular_values();
        let rank = values
            .iter()
            .filter(|value| **value > RANK * values.max())
            .count();
        let dimension = N - rank;
        let corners = self.corners(inside, if dimension == 0 { 0 } else { sticking });
        let state: [f64; N] = if corners.is_empty() {
            inside
        } else {
            std::array::from_fn(|j| {
                corners.iter().map(|c| c[j]).sum::<f64>() / corners.len() as f64
            })
        };
        let state = self.solve(state, &[])?;
        let extreme = |pick: fn(f64, f64) -> f64| {
            std::array::from_fn(|j| corners.iter().map(|c| c[j]).fold(state[j], pick))
        };
        let field = self.system.linear(&state, &self.mode).ok()?.field;
        let jacobian = DMatrix::from_fn(N, N, |i, j| field[i].slopes().0[j]);
        self.admissible(&state).then(|| StickingSet {
            mode: self.mode,
            dimension,
            state,
            low: extreme(f64::min),
            high: extreme(f64::max),
            spectrum: Spectrum::across(&jacobian, sticking + dimension),
        })
    }

    /// States at which each sticking contact bears its limit, one way or the other.
    fn corners(&self, inside: [f64; N], sticking: usize) -> Vec<[f64; N]> {
        if sticking == 0 || sticking > CORNERS {
            return Vec::new();
        }
        let signs = |k: usize| (0..sticking).map(move |i| if k >> i & 1 == 0 { -1.0 } else { 1.0 });
        let corner = |k: usize| self.solve(inside, &signs(k).collect::<Vec<f64>>());
        (0..1 << sticking).filter_map(corner).collect()
    }

    /// Whether every force can be had, and every sliding contact slides its way.
    fn admissible(&self, state: &[f64; N]) -> bool {
        let Ok(contacts) = self.system.contact_states(state, &self.mode) else {
            return false;
        };
        let modes = self.mode.as_slice().iter();
        modes
            .zip(contacts.as_ref())
            .all(|(mode, contact)| match mode {
                Mode::Stick => contact.stick > 0.0 && contact.force.abs() <= contact.stick,
                sliding => contact.speed * sliding.sign() > 0.0,
            })
    }

    /// f = 0, w = 0 of the sticking contacts, and, for signs given, their forces at the limit.
    fn equations(&self, state: &[f64; N], signs: &[f64]) -> Option<Vec<Equation<N>>> {
        let at = self.system.linear(state, &self.mode).ok()?;
        let mut all: Vec<M::Lanes> = at.field.to_vec();
        all.extend(self.mode.sticking().map(|i| at.speed.as_ref()[i]));
        let held = self.mode.sticking().zip(signs);
        all.extend(held.map(|(i, sign)| at.force.as_ref()[i] - at.stick.as_ref()[i] * *sign));
        Some(
            all.iter()
                .map(|lane| (lane.re(), lane.slopes().0))
                .collect(),
        )
    }

    /// Gauss and Newton's shortest steps; `None` unless every equation is fulfilled in the end.
    fn solve(&self, mut state: [f64; N], signs: &[f64]) -> Option<[f64; N]> {
        for _ in 0..ITERATIONS {
            let equations = self.equations(&state, signs)?;
            let matrix = DMatrix::from_fn(equations.len(), N, |i, j| equations[i].1[j]);
            let right = DVector::from_fn(equations.len(), |i, _| -equations[i].0);
            if !matrix.iter().chain(&right).all(|number| number.is_finite()) {
                return None;
            }
            let done = (0..equations.len()).all(|i| {
                let terms: f64 = (0..N).map(|j| (matrix[(i, j)] * state[j]).abs()).sum();
                right[i].abs() <= FULFILLED * terms.max(matrix.row(i).norm())
            });
            if done {
                return Some(state);
            }
            let svd = matrix.try_svd(true, true, f64::EPSILON, 10_000)?;
            let step = svd.solve(&right, RANK * svd.singular_values.max()).ok()?;
            for (y, change) in state.iter_mut().zip(&step) {
                *y += change;
            }
        }
        None
    }
}

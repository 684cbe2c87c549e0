//! Equilibria at which contacts stick, or rest on what does not give way: sets of states, bounded by what friction can
//! hold.

use nalgebra::{DMatrix, DVector};

use super::Spectrum;
use super::free::{modulo_kernel, restricted};
use super::resting::held;
use crate::field::exact::Mode;
use crate::linear::svd;
use crate::motion::{Contacts, Flow, Modes, Place, Row, sticking};

const ITERATIONS: usize = 60;
/// Equations are fulfilled to this, relative to their terms.
const FULFILLED: f64 = 1e-11;
/// Singular values below this share of the largest are zero.
const RANK: f64 = 1e-9;
/// Contacts whose corners are tried one by one.
const CORNERS: usize = 6;

/// All equilibria in one mode in which contacts stick.
#[derive(Debug, Clone, PartialEq)]
pub struct StickingSet {
    /// The mode of each contact.
    pub modes: Modes,
    /// How many directions it has: 0 for a single state, 1 for an interval.
    pub dimension: usize,
    /// A state in it.
    pub state: Vec<f64>,
    /// Smallest value of each state at its corners, where every sticking contact is at its limit.
    pub low: Vec<f64>,
    /// Largest value of each state there.
    pub high: Vec<f64>,
    /// Eigenvalues for motions that leave the set while the contacts stick.
    pub spectrum: Spectrum,
}

/// The sticking equilibria of `flow`, looked for from each of `starts` in each of `modes`; a mode is reported once.
#[must_use]
pub fn sticking_sets(flow: &dyn Flow, starts: &[Vec<f64>], modes: &[Modes]) -> Vec<StickingSet> {
    let set = |modes: &Modes| {
        starts.iter().find_map(|start| {
            let modes = &pinned(flow, modes, start)?;
            Sought { flow, modes }.set(start)
        })
    };
    modes.iter().filter_map(set).collect()
}

/// The modes with what sticks pinned where a press at rest holds the same; `None` if it is to slide there.
fn pinned(flow: &dyn Flow, modes: &Modes, start: &[f64]) -> Option<Modes> {
    let pinned = flow.pinned(modes.clone(), start);
    let mut pairs = pinned.iter().zip(modes);
    let stays = pairs.all(|(now, before)| now == before || *before == Mode::Stick);
    stays.then_some(pinned)
}

struct Sought<'a> {
    flow: &'a dyn Flow,
    modes: &'a Modes,
}

impl Sought<'_> {
    fn set(&self, start: &[f64]) -> Option<StickingSet> {
        let sticking = self
            .modes
            .iter()
            .filter(|mode| **mode == Mode::Stick)
            .count();
        let inside = self.solve(start, &[])?;
        let dimension = inside.len() - self.rank(&inside)?;
        let corners = self.corners(&inside, if dimension == 0 { 0 } else { sticking });
        let state = self.solve(&middle(&corners).unwrap_or(inside), &[])?;
        let extreme = |pick: fn(f64, f64) -> f64| {
            let most = |(j, y): (usize, &f64)| corners.iter().map(|c| c[j]).fold(*y, pick);
            state.iter().enumerate().map(most).collect()
        };
        let (low, high) = (extreme(f64::min), extreme(f64::max));
        let at = self.at(&state)?;
        if !self.admissible(&state, &at) {
            return None;
        }
        Some(StickingSet {
            modes: self.modes.clone(),
            dimension,
            low,
            high,
            spectrum: self.spectrum(&state, &at.jacobian, dimension)?,
            state,
        })
    }

    /// Eigenvalues of what the contacts leave free, without the directions of the set.
    fn spectrum(
        &self,
        state: &[f64],
        jacobian: &DMatrix<f64>,
        dimension: usize,
    ) -> Option<Spectrum> {
        let held = held(self.flow, &self.place(state)).ok()?;
        let stuck = self.modes.iter().filter(|mode| **mode == Mode::Stick);
        let stuck = stuck.count();
        let order = state.len();
        let held = DMatrix::from_fn(held.len(), order, |i, j| held[i].slopes[j]);
        // A gap that stays closed has no rate either.
        let rates = held.rows_range(stuck..) * jacobian;
        let (holds, rests) = (held.nrows(), rates.nrows());
        let mut rows = held.resize_vertically(holds + rests, 0.0);
        rows.rows_range_mut(holds..).copy_from(&rates);
        let left = modulo_kernel(&restricted(jacobian, &rows), dimension);
        let apart = order.checked_sub(sticking(self.modes) + dimension)?;
        // Contacts that hold the same leave a zero more than they take.
        let twice = left.nrows().saturating_sub(apart);
        Some(Spectrum::across(&left, twice))
    }

    fn rank(&self, inside: &[f64]) -> Option<usize> {
        let (matrix, _) = self.equations(inside, &[])?;
        let values = svd(matrix)?.singular_values;
        let least = RANK * values.max();
        Some(values.iter().filter(|value| **value > least).count())
    }

    /// States at which each sticking contact bears its limit, one way or the other.
    fn corners(&self, inside: &[f64], sticking: usize) -> Vec<Vec<f64>> {
        if sticking == 0 || sticking > CORNERS {
            return Vec::new();
        }
        let signs = |k: usize| (0..sticking).map(move |i| if k >> i & 1 == 0 { -1.0 } else { 1.0 });
        let corner = |k: usize| self.solve(inside, &signs(k).collect::<Vec<f64>>());
        (0..1 << sticking).filter_map(corner).collect()
    }

    /// Whether every force can be had and read, and every sliding contact slides its way.
    fn admissible(&self, state: &[f64], at: &Contacts) -> bool {
        let holds = self.flow.read(&self.place(state)).is_ok();
        holds
            && self.flow.pinned(self.modes.clone(), state) == *self.modes
            && self.modes.iter().zip(&at.all).all(|(mode, contact)| {
                let stick = contact.stick.value;
                match mode {
                    Mode::Stick => stick > 0.0 && contact.force.value.abs() <= stick,
                    Mode::Loose | Mode::PinnedForward | Mode::PinnedBackward => true,
                    Mode::Rest => contact.force.value > 0.0,
                    sliding => contact.speed.value * sliding.sign() > 0.0,
                }
            })
    }

    fn place(&self, state: &[f64]) -> Place {
        Place {
            state: state.to_vec(),
            modes: self.modes.clone(),
        }
    }

    fn at(&self, state: &[f64]) -> Option<Contacts> {
        self.flow.contacts(&self.place(state)).ok()
    }

    /// f = 0, w = 0 of the sticking contacts, closed gaps, and, for signs given, forces at the limit: as a matrix of slopes,
    /// and what is missing.
    fn equations(&self, state: &[f64], signs: &[f64]) -> Option<(DMatrix<f64>, DVector<f64>)> {
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
        let matrix = DMatrix::from_fn(order + more.len(), order, |i, j| {
            match i.checked_sub(order) {
                None => jacobian[(i, j)],
                Some(i) => more[i].slopes[j],
            }
        });
        let values = f.iter().copied().chain(more.iter().map(|row| row.value));
        let missing = values.map(|value| -value).collect::<Vec<f64>>();
        Some((matrix, DVector::from_vec(missing)))
    }

    /// Gauss and Newton's shortest steps; `None` unless every equation is fulfilled in the end.
    fn solve(&self, start: &[f64], signs: &[f64]) -> Option<Vec<f64>> {
        let mut state = start.to_vec();
        for _ in 0..ITERATIONS {
            let (matrix, right) = self.equations(&state, signs)?;
            if !matrix.iter().chain(&right).all(|number| number.is_finite()) {
                return None;
            }
            let done = matrix.row_iter().zip(&right).all(|(row, right)| {
                let terms: f64 = row.iter().zip(&state).map(|(g, y)| (g * y).abs()).sum();
                right.abs() <= FULFILLED * terms.max(row.norm())
            });
            if done {
                return Some(state);
            }
            let svd = svd(matrix)?;
            let step = svd.solve(&right, RANK * svd.singular_values.max()).ok()?;
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

/// The mean of some states; `None` if there is none.
fn middle(corners: &[Vec<f64>]) -> Option<Vec<f64>> {
    let count = corners.len() as f64;
    let mean = |j: usize| corners.iter().map(|c| c[j]).sum::<f64>() / count;
    Some((0..corners.first()?.len()).map(mean).collect())
}

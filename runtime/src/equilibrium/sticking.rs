//! Equilibria at which contacts stick, or rest on what does not give way: sets of states, bounded by what friction can
//! hold.

use nalgebra::{DMatrix, DVector};

use super::Spectrum;
use super::free::{modulo_kernel, restricted};
use super::resting::held;
use super::sticking_equations::{RANK, Sought};
use crate::field::exact::Mode;
use crate::linear::svd;
use crate::motion::{Contacts, Flow, Modes, sticking};

/// Distance of two sets, in units of their states, up to which they may be one.
const SAME: f64 = 1e-7;
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

/// The sticking equilibria of `flow`, looked for from each of `starts` in each of `modes`, each set once.
#[must_use]
pub fn sticking_sets(flow: &dyn Flow, starts: &[Vec<f64>], modes: &[Modes]) -> Vec<StickingSet> {
    let sets = |modes: &Modes| {
        let mut found: Vec<StickingSet> = Vec::new();
        for start in starts {
            if let Some(set) = further(flow, modes, start, &found) {
                found.push(set);
            }
        }
        found
    };
    modes.iter().flat_map(sets).collect()
}

/// The set to which a start leads, unless it has been found.
fn further(
    flow: &dyn Flow,
    modes: &Modes,
    start: &[f64],
    found: &[StickingSet],
) -> Option<StickingSet> {
    let modes = &pinned(flow, modes, start)?;
    let sought = Sought::new(flow, modes, start)?;
    if found.iter().any(|set| sought.is_straight(start, set)) {
        return None;
    }
    let inside = sought.solve(start, &[])?;
    let sought = Sought::new(flow, modes, &inside)?;
    let set = sought.set(&inside)?;
    let meets = |old: &StickingSet| old.meets(&set, &sought.sizes);
    (!found.iter().any(meets)).then_some(set)
}

impl StickingSet {
    /// Whether the two have a state in common, as far as their corners tell, where states are of these sizes.
    fn meets(&self, other: &Self, sizes: &[f64]) -> bool {
        let sides = self.low.iter().zip(&self.high);
        let others = other.low.iter().zip(&other.high);
        sides
            .zip(others)
            .zip(sizes)
            .all(|(((low, high), (other_low, other_high)), size)| {
                let blur = SAME * low.abs().max(high.abs()).max(*size);
                low - blur <= *other_high && *other_low <= high + blur
            })
    }
}

/// The modes with what sticks pinned where a press at rest holds the same; `None` if it is to slide there.
fn pinned(flow: &dyn Flow, modes: &Modes, start: &[f64]) -> Option<Modes> {
    let pinned = flow.pinned(modes.clone(), start);
    let mut pairs = pinned.iter().zip(modes);
    let stays = pairs.all(|(now, before)| now == before || *before == Mode::Stick);
    stays.then_some(pinned)
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
        if !self.admissible(&state, &at) || !self.joins(&state, &corners) {
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

    /// Whether all between a state and these corners is in the set as well: corners of two sets make none.
    fn joins(&self, state: &[f64], corners: &[Vec<f64>]) -> bool {
        corners.iter().all(|corner| {
            let half: Vec<f64> = (state.iter().zip(corner))
                .map(|(a, b)| f64::midpoint(*a, *b))
                .collect();
            let half = self.solve(&half, &[]);
            half.is_some_and(|half| self.at(&half).is_some_and(|at| self.admissible(&half, &at)))
        })
    }

    /// Whether the equations at a start are linear continuations of those in a set, to which they lead then.
    fn is_straight(&self, start: &[f64], set: &StickingSet) -> bool {
        let limits = vec![1.0; self.modes.len()];
        let [here, there] = [start, &set.state].map(|state| self.equations(state, &limits));
        let (Some((here, lacks)), Some((there, lacked))) = (here, there) else {
            return false;
        };
        let way = start.iter().zip(&set.state).zip(&self.sizes);
        let way = way.map(|((to, from), size)| (to - from) / size);
        let way = DVector::from_iterator(start.len(), way);
        let bends = (lacks + &there * &way - lacked).amax() > RANK * way.amax();
        self.modes == &set.modes && !bends && (here - there).amax() <= RANK
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
}

/// The mean of some states; `None` if there is none.
fn middle(corners: &[Vec<f64>]) -> Option<Vec<f64>> {
    let count = corners.len() as f64;
    let mean = |j: usize| corners.iter().map(|c| c[j]).sum::<f64>() / count;
    Some((0..corners.first()?.len()).map(mean).collect())
}

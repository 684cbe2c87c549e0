//! What the exact system says of an equilibrium of its smooth copy.

use std::cell::OnceCell;
use std::ops::ControlFlow;

use super::case::{Along, Case, Dynamics};
use super::declared::Declared;
use super::equilibrium::{EquilibriumRecord, SpecialEquilibrium};
use super::modes::{sliding_modes, sticking_modes};
use crate::bifurcation::Stability;
use crate::equilibrium::{Found, find, follow, settings, sticking_sets};
use crate::field::Design;
use crate::model::Model;

/// Special points of both systems this close, relative to r, are the same one.
const SHIFT: f64 = 0.1;

/// The exact system of a case with a smoothing.
pub(super) struct Counterpart<M: Model<N>, const N: usize> {
    case: Case,
    special: OnceCell<Vec<Found<N>>>,
    model: M,
}

impl<M: Model<N>, const N: usize> Counterpart<M, N> {
    pub(super) fn new(case: &Case) -> Self {
        Self {
            case: Case {
                dynamics: Dynamics::Exact,
                ..case.clone()
            },
            special: OnceCell::new(),
            model: Declared::<M, N>::model(case),
        }
    }

    /// Whether the exact system has no equilibrium there, or one of another stability.
    pub(super) fn differs(&self, copy: &EquilibriumRecord) -> bool {
        let decided = |stability| stability != Stability::Undecided;
        match self.stability(&copy.state) {
            None => true,
            Some(exact) => decided(exact) && decided(copy.stability) && exact != copy.stability,
        }
    }

    /// The stability of the exact equilibrium near a state.
    fn stability(&self, state: &[f64]) -> Option<Stability> {
        let alone = Case {
            along: None,
            ..self.case.clone()
        };
        let start = std::array::from_fn(|j| state.get(j).copied().unwrap_or(0.0));
        let family = Declared::<M, N>::exact(&alone);
        let first = |y: &[f64; N]| sliding_modes(&self.model, y).into_iter().take(1).collect();
        let sliding = find(&family, 0.0, &[start], first).pop();
        sliding.map(|one| one.spectrum.stability).or_else(|| {
            let sets = sticking_sets(&self.model, &[start], &sticking_modes()).ok()?;
            sets.first().map(|set| set.spectrum.stability)
        })
    }

    /// Whether the exact system, followed along the same way, has no such special point nearby.
    pub(super) fn lacks(&self, along: Along, copy: &SpecialEquilibrium) -> bool {
        if self.case.along.is_none() || M::INFO.contacts.is_empty() {
            return false;
        }
        let special = self
            .special
            .get_or_init(|| self.followed(along, &copy.state));
        let same = |exact: &Found<N>| {
            exact.kind.name() == copy.kind && (exact.spot.r - copy.r).abs() <= SHIFT * copy.r.abs()
        };
        !special.iter().any(same)
    }

    /// What happens to the exact equilibrium; nothing along the size of a smoothing, which it does not know.
    fn followed(&self, along: Along, state: &[f64]) -> Vec<Found<N>> {
        if along.design == Design::Smoothing {
            return Vec::new();
        }
        let (from, to) = along.span();
        let family = Declared::<M, N>::exact(&self.case);
        let start = std::array::from_fn(|j| state.get(j).copied().unwrap_or(0.0));
        let first = find(&family, from, &[start], |y| sliding_modes(&self.model, y)).pop();
        first
            .and_then(|first| {
                follow(&family, &first.place, settings(from, to), &mut |_| {
                    ControlFlow::Continue(())
                })
                .ok()
            })
            .map_or_else(Vec::new, |branch| branch.special)
    }
}

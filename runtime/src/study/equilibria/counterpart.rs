//! What the exact system says of an equilibrium of its smooth copy.

use std::cell::OnceCell;
use std::ops::ControlFlow;

use super::modes::{sliding_mode, sliding_modes, sticking_modes};
use super::record::{EquilibriumRecord, SpecialEquilibrium};
use crate::bifurcation::Stability;
use crate::continuation::Located;
use crate::equilibrium::{EquilibriumPoint, find, follow, settings, sticking_sets};
use crate::field::Design;
use crate::study::question::{Along, Case, Dynamics};
use crate::study::system::System;

/// Special points of both systems this close, relative to r, are the same one.
const SHIFT: f64 = 0.1;

/// The exact system of a case with a smoothing.
pub(in crate::study) struct Counterpart<'a> {
    system: &'a System,
    case: Case,
    special: OnceCell<Vec<Located<EquilibriumPoint>>>,
}

impl<'a> Counterpart<'a> {
    pub(in crate::study) fn new(system: &'a System, case: &Case) -> Self {
        Self {
            system,
            case: Case {
                dynamics: Dynamics::Exact,
                ..case.clone()
            },
            special: OnceCell::new(),
        }
    }

    /// Whether the exact system has no equilibrium there, or one of another stability.
    pub(in crate::study) fn differs(&self, copy: &EquilibriumRecord) -> bool {
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
        let family = self.system.family(&alone);
        let flow = family.at(0.0).ok()?;
        let start = [state.to_vec()];
        let info = self.system.info();
        let sliding = find(&family, 0.0, &start, |y| {
            vec![sliding_mode(&*flow, info, y)]
        })
        .pop();
        sliding.map(|one| one.spectrum.stability).or_else(|| {
            let modes = sticking_modes(&*flow, info);
            let sets = sticking_sets(&*flow, &start, &modes);
            sets.first().map(|set| set.spectrum.stability)
        })
    }

    /// Whether the exact system, followed along the same way, has no such special point nearby.
    pub(in crate::study) fn lacks(&self, along: Along, copy: &SpecialEquilibrium) -> bool {
        if self.case.along.is_none() {
            return false;
        }
        let special = self
            .special
            .get_or_init(|| self.followed(along, &copy.state).unwrap_or_default());
        let same = |exact: &Located<EquilibriumPoint>| {
            exact.kind == copy.kind && (exact.r - copy.r).abs() <= SHIFT * exact.point.r_scale
        };
        !special.iter().any(same)
    }

    /// What happens to the exact equilibrium; nothing along the size of a smoothing, which it does not know.
    fn followed(&self, along: Along, state: &[f64]) -> Option<Vec<Located<EquilibriumPoint>>> {
        if along.design == Design::Smoothing {
            return None;
        }
        let (from, to) = along.span();
        let family = self.system.family(&self.case);
        let flow = family.at(from).ok()?;
        let start = [state.to_vec()];
        let first = find(&family, from, &start, |y| {
            sliding_modes(&*flow, self.system.info(), y)
        })
        .pop()?;
        let mut go_on = |_: &_| ControlFlow::Continue(());
        let followed = follow(&family, &first.place, settings(from, to), &mut go_on);
        let (walked, _) = followed.ok()?;
        Some(walked.located)
    }
}

//! Equilibria beside the one that is followed.

use super::record::EquilibriumRecord;
use crate::motion::apart;
use crate::study::question::Case;
use crate::study::system::System;

/// Distance within which two states are one equilibrium, relative to their size, or to 1 where that is less.
const SAME: f64 = 1e-6;

impl System {
    /// The equilibria at the value with which a branch begins that are none of its points.
    pub(super) fn not_passed(
        &self,
        case: &Case,
        points: &[EquilibriumRecord],
    ) -> Vec<EquilibriumRecord> {
        let Some(first) = points.first() else {
            return Vec::new();
        };
        let mut found = self.equilibria(case).unwrap_or_default();
        let there = || points.iter().filter(|point| point.r == first.r);
        found.retain(|one| !there().any(|point| same(point, one)));
        found
    }
}

fn same(a: &EquilibriumRecord, b: &EquilibriumRecord) -> bool {
    let units: Vec<f64> = a.state.iter().map(|value| value.abs().max(1.0)).collect();
    a.mode == b.mode && apart(&a.state, &b.state, &units) <= SAME
}

//! Special points of a branch, numbered as they are found.

use std::collections::HashMap;

use nalgebra::Complex;

use super::case::Along;
use crate::bifurcation::{Findings, Kind, Unexplained, Watched};

/// A point of a branch where something changes.
#[derive(Debug, Clone, PartialEq)]
pub struct Special {
    /// What changes: `fold`, `flip`, `torus`, `grazing-sliding`, ...
    pub kind: &'static str,
    /// Kind and number, for instance `PD1`.
    pub label: String,
    /// The design variable, in the user's own values.
    pub r: f64,
    /// The period there.
    pub period: f64,
    /// The multipliers there.
    pub multipliers: Vec<Complex<f64>>,
}

/// The special points of a branch under way.
pub(super) struct Specials {
    pub(super) along: Along,
    points: Vec<Special>,
    counts: HashMap<Kind, usize>,
    unexplained: Option<Unexplained>,
}

impl Specials {
    pub(super) fn new(along: Along) -> Self {
        Self {
            along,
            points: Vec::new(),
            counts: HashMap::new(),
            unexplained: None,
        }
    }

    /// Takes what was found on one step.
    pub(super) fn take<P: Watched>(&mut self, findings: Findings<P>) {
        for found in findings.located {
            let count = self.counts.entry(found.kind).or_default();
            *count += 1;
            self.points.push(Special {
                kind: found.kind.name(),
                label: format!("{}{count}", found.kind.letters()),
                r: self.along.value(found.r),
                period: found.point.period(),
                multipliers: found.point.floquet().multipliers.clone(),
            });
        }
        let first = findings.unexplained.into_iter().next();
        self.unexplained = self.unexplained.take().or(first.map(|change| Unexplained {
            between: change.between.map(|r| self.along.value(r)),
            ..change
        }));
    }

    /// The first change that no special point accounts for.
    pub(super) fn unexplained(&self) -> Option<&Unexplained> {
        self.unexplained.as_ref()
    }

    /// All special points.
    pub(super) fn finish(self) -> Vec<Special> {
        self.points
    }
}

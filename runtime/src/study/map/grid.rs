//! A grid of two parameters.

use super::cell::Cell;
use super::question::Asked;
use crate::study::error::StudyError;
use crate::study::question::{Along, Case};
use crate::study::system::System;
use crate::study::work::{List, Watch};

/// Two parameters with so many values each.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    /// The parameters: across, and up.
    pub along: [Along; 2],
    /// How many values of each.
    pub values: [usize; 2],
}

/// A map.
#[derive(Debug, Clone, PartialEq)]
pub struct MapRecord {
    /// Its grid.
    pub grid: Grid,
    /// What was asked.
    pub asked: Asked,
    /// The nodes that are there, the first parameter changing first: their values, and the answers.
    pub nodes: Vec<([f64; 2], Cell)>,
    /// How many are not, because it was interrupted.
    pub missing: usize,
}

impl Grid {
    /// How many nodes it has; `None` if they cannot be counted.
    #[must_use]
    pub fn count(&self) -> Option<usize> {
        self.values[0].checked_mul(self.values[1])
    }

    /// The values of both parameters, smallest first.
    #[must_use]
    pub fn axes(&self) -> [Vec<f64>; 2] {
        [0, 1].map(|k| {
            let along = self.along[k];
            let all = along.spaced(self.values[k]).into_iter();
            all.map(|r| along.value(r)).collect()
        })
    }

    /// The case at these values.
    fn at(&self, case: &Case, [a, b]: [f64; 2]) -> Case {
        let set = |case: Case, along: Along, value: f64| {
            let along = Some(along);
            Case { along, ..case }.at(value)
        };
        let case = set(set(case.clone(), self.along[0], a), self.along[1], b);
        Case {
            along: None,
            ..case
        }
    }
}

impl System {
    /// The answer at each node of a grid; `list` has an item for each, and `watch` sees it.
    ///
    /// # Errors
    /// The case cannot be asked at a corner of the grid.
    pub fn map_watched(
        &self,
        case: &Case,
        (grid, asked): (&Grid, &Asked),
        list: &List<Cell>,
        watch: Watch<'_, Cell>,
    ) -> Result<MapRecord, StudyError> {
        let (axes, count) = (grid.axes(), grid.count().unwrap_or(usize::MAX));
        let node = |number: usize| {
            let (i, j) = (number % axes[0].len(), number / axes[0].len());
            [axes[0][i], axes[1][j]]
        };
        let ends = axes
            .each_ref()
            .map(|axis| [axis.first(), axis.last()].into_iter().flatten());
        for b in ends[1].clone() {
            for a in ends[0].clone() {
                self.check(&grid.at(case, [*a, *b]))?;
            }
        }
        let one = |number| asked.of(self, &grid.at(case, node(number)));
        let found = list.work(count, one, watch);
        Ok(MapRecord {
            grid: grid.clone(),
            asked: asked.clone(),
            missing: count - found.len(),
            nodes: found
                .into_iter()
                .map(|(number, cell)| (node(number), cell))
                .collect(),
        })
    }
}

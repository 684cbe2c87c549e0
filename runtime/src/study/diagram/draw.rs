//! The diagram of a case, value by value.

use std::collections::BTreeMap;

use super::record::{DiagramRecord, SweepRecord};
use super::setting::{Diagram, Sweep};
use super::slice::{Cut, Slice};
use super::sweep::Hand;
use crate::study::error::StudyError;
use crate::study::question::{Along, Case};
use crate::study::system::System;
use crate::study::work::{List, Watch};

impl System {
    /// Where the motions of the case meet a section, for many values of its design variable: `list` has an item for each
    /// value of each sweep, sweep after sweep, in the rows of [`Diagram::rows`], and `watch` sees each.
    ///
    /// # Errors
    /// Nothing is followed, or the case cannot be asked.
    pub fn diagram_watched(
        &self,
        case: &Case,
        diagram: &Diagram,
        list: &List<Slice>,
        watch: Watch<'_, Slice>,
    ) -> Result<DiagramRecord, StudyError> {
        self.check(case)?;
        let along = case.along.ok_or(StudyError::NothingToFollow)?;
        let (family, start) = (self.family(case), self.start(case));
        let cut = Cut {
            family: &family,
            diagram,
            along,
        };
        let values = diagram.all(along);
        let one = |hand: &mut Hand, number: usize, known: Option<Slice>| {
            let new = || cut.slice(values[number], hand.starts(), &hand.scale);
            let slice = known.unwrap_or_else(new);
            hand.take(&slice);
            slice
        };
        let rows = diagram.rows();
        let found = list.work_in_rows(rows, || Hand::new(&start), one, watch);
        Ok(DiagramRecord {
            along,
            diagram: *diagram,
            missing: rows.items() - found.len(),
            sweeps: diagram.records(found),
        })
    }
}

impl Diagram {
    /// The values of all items, as the family counts them.
    fn all(&self, along: Along) -> Vec<f64> {
        let mut values = along.spaced(self.values);
        let mut of = |sweep: &Sweep| {
            if *sweep == Sweep::Down {
                values.reverse();
            }
            values.clone()
        };
        self.sweeps().iter().flat_map(&mut of).collect()
    }

    /// The sweeps with what is there of them.
    fn records(&self, found: BTreeMap<usize, Slice>) -> Vec<SweepRecord> {
        let record = |sweep: &Sweep| SweepRecord {
            name: sweep.name(),
            slices: Vec::new(),
        };
        let mut records: Vec<SweepRecord> = self.sweeps().iter().map(record).collect();
        for (item, slice) in found {
            let name = self.sweep_of(item).name();
            let mut records = records.iter_mut();
            if let Some(record) = records.find(|record| record.name == name) {
                record.slices.push(slice);
            }
        }
        records
    }
}

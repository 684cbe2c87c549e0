//! Rows that a table has whatever else is left out of it: where a state is least or largest, and the last.

use super::follow::{Point, Row};
use crate::flow::FlowError;

/// The rows where each state is least and largest, and the last one.
#[derive(Debug, Default)]
pub(super) struct Extremes {
    /// For each state where it is least, and where it is largest.
    sides: Vec<[Row; 2]>,
    last: Option<Row>,
}

impl Extremes {
    /// One more point of the motion.
    pub(super) fn offer(&mut self, point: &Point<'_>) -> Result<(), FlowError> {
        if self.sides.is_empty() {
            let row = point.row()?;
            self.sides = row
                .state
                .iter()
                .map(|_| [row.clone(), row.clone()])
                .collect();
        }
        for (j, (value, [low, high])) in point.values().zip(&mut self.sides).enumerate() {
            if value < low.state[j] {
                *low = point.row()?;
            } else if value > high.state[j] {
                *high = point.row()?;
            }
        }
        Ok(())
    }

    /// The last point so far.
    pub(super) fn end(&mut self, point: &Point<'_>) -> Result<(), FlowError> {
        self.last = Some(point.row()?);
        Ok(())
    }

    /// All of them, in the order of time.
    pub(super) fn rows(self) -> Vec<Row> {
        let mut rows: Vec<Row> = self.sides.into_iter().flatten().chain(self.last).collect();
        rows.sort_by(|a, b| a.time.total_cmp(&b.time));
        rows.dedup_by(|a, b| a.time == b.time);
        rows
    }
}

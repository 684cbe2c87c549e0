//! What the branches cost, beside what they cost in 1996.

use stickslip::report::{Manuscript, ReportError, Section};

use super::branch::Branch;
use super::words::{count, duration};

/// The cost of one branch.
pub(super) struct Cost {
    branch: String,
    thesis: &'static str,
    cells: [String; 7],
}

impl Cost {
    /// What a branch along `name` cost.
    pub(super) fn of(name: &str, branch: &Branch, thesis: &'static str) -> Self {
        let Branch { along, work, .. } = branch;
        Self {
            branch: format!("{name} from {} to {}", along.from, along.to),
            thesis,
            cells: [
                count(branch.points.len() as u64),
                count(work.steps),
                count(work.evaluations),
                count(work.linearisations),
                count(work.factorisations),
                count(work.newton),
                duration(branch.time),
            ],
        }
    }
}

/// The section on cost.
pub(super) fn section(costs: Vec<Cost>) -> Result<Section, ReportError> {
    let rows = costs.into_iter().map(|cost| {
        let mut row = vec![cost.branch];
        row.extend(cost.cells);
        row.push(cost.thesis.to_owned());
        row
    });
    Manuscript::new(include_str!("cost.md"))
        .rows("cost", rows)
        .section()
}

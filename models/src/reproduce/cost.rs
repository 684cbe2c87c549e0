//! What the branches cost, beside what they cost in 1996.

use stickslip::report::{Column, Section, Table};

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
pub(super) fn section(costs: Vec<Cost>) -> Section {
    let heads = ["points", "steps", "*f*", "*f*, *J*", "LU", "Newton", "time"];
    let columns = std::iter::once(Column::words("branch"))
        .chain(heads.map(Column::numbers))
        .chain([Column::numbers("thesis (CPU)")]);
    let table = Table::new(
        "cost",
        "What each branch cost. *Points*: orbits on it. *Steps*: accepted steps of the integrator. *f*: evaluations of \
         the right-hand side alone; *f*, *J*: with its derivatives with respect to state and parameter. *LU*: \
         factorisations in implicit steps. *Newton*: iterations of shooting, each one motion once around the orbit. \
         *Time*: elapsed time of this run, several branches sharing the cores; the counts are the same on every machine.",
        columns,
    );
    let rows = costs.into_iter().map(|cost| {
        let mut row = vec![cost.branch];
        row.extend(cost.cells);
        row.push(cost.thesis.to_owned());
        row
    });
    Section::new("What it cost")
        .text(
            "The thesis gives the processor time of its workstation for each branch; here is what the same branches \
             cost today. Most of the gap is thirty years of hardware, the rest is method: exact derivatives of the \
             discretised motion, steps that see the friction layer, and extrema taken from the motion itself instead \
             of from a grid of output points.",
        )
        .table(table.rows(rows))
}

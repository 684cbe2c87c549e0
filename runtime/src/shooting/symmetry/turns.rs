//! What comes round: the phase of a drive, and states that run on, each modulo what changes nothing.

use std::f64::consts::TAU;

/// The turn of each state, zero where none is: two values that differ by that are one.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Turns(Vec<f64>, Option<usize>);

impl Turns {
    /// Of this many states, one of them the phase of a drive, that gain this once around.
    pub(super) fn of(order: usize, drive: Option<usize>, shift: Option<&[f64]>) -> Self {
        let gain = |j: usize| shift.map_or(0.0, |shift| shift[j].abs());
        let turn = |j: usize| if drive == Some(j) { TAU } else { gain(j) };
        Self((0..order).map(turn).collect(), drive)
    }

    /// How many states there are.
    pub(super) fn order(&self) -> usize {
        self.0.len()
    }

    /// Whether a state comes round.
    pub(super) fn has(&self, state: usize) -> bool {
        self.0[state] != 0.0
    }

    /// What is left of the distance between two values of a state without whole turns.
    pub(super) fn rest(&self, state: usize, apart: f64) -> f64 {
        match self.0[state] {
            0.0 => apart,
            turn => apart - turn * (apart / turn).round(),
        }
    }

    /// Half a turn of nothing, of the drive, of all that runs on, or of both.
    pub(super) fn halves(&self) -> Vec<Vec<f64>> {
        let half = |of: &dyn Fn(usize) -> bool| -> Vec<f64> {
            let turns = self.0.iter().enumerate();
            turns
                .map(|(j, turn)| if of(j) { 0.5 * turn } else { 0.0 })
                .collect()
        };
        let is_drive = |j: usize| self.1 == Some(j);
        let mut halves = vec![half(&|_| false), half(&is_drive)];
        halves.extend([half(&|j| !is_drive(j)), half(&|_| true)]);
        // Where nothing is driven, or nothing runs on, some of them are one.
        let mut each: Vec<Vec<f64>> = Vec::new();
        for one in halves {
            if !each.contains(&one) {
                each.push(one);
            }
        }
        each
    }
}

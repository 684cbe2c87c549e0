//! How many harmonics a periodic motion takes.

use nalgebra::Complex;

use super::around::{Around, Motion, PANEL, ROUNDING, rate};
use crate::flow::FlowError;
use crate::motion::{Flow, Node};

/// Harmonics up to which series are summed: more where these do not suffice.
const SUMMED: [usize; 2] = [30, 300];

/// For each state and each of these accuracies, the fewest harmonics with which, and with any more than which, the Fourier
/// series of a motion misses that state nowhere, at the nodes of its quadrature, by more than that share of half its
/// extent; `None` where 300 do not suffice.
///
/// It is what a method of harmonic balance needs at least.
///
/// # Errors
/// The motion cannot be followed.
pub fn series(
    flow: &dyn Flow,
    around: Around<'_>,
    accuracies: &[f64],
) -> Result<Vec<Vec<Option<usize>>>, FlowError> {
    let rate = rate(flow, around)?;
    let mut found = Vec::new();
    for highest in SUMMED {
        let panel = PANEL / ((1.0 + highest as f64) * rate);
        let motion = Motion::around(flow, around, panel)?;
        let misses = motion.misses(highest);
        let least = |j: usize| {
            let to = |accuracy: &f64| fewest(misses.iter().map(|one| one[j]), *accuracy);
            accuracies.iter().map(to).collect()
        };
        found = (0..motion.start.len()).map(least).collect();
        let all = |one: &Vec<Option<usize>>| one.iter().all(Option::is_some);
        if found.iter().all(all) {
            break;
        }
    }
    Ok(found)
}

/// The place of the first value from which on all are at most this.
fn fewest(values: impl Iterator<Item = f64>, most: f64) -> Option<usize> {
    let values: Vec<f64> = values.collect();
    let beyond = values.iter().rposition(|value| *value > most);
    let next = beyond.map_or(0, |last| last + 1);
    (next < values.len()).then_some(next)
}

impl Motion {
    /// By how much a series that ends with each harmonic misses each state at worst, over half its extent.
    fn misses(&self, highest: usize) -> Vec<Vec<f64>> {
        let states = 0..self.start.len();
        let left = |node: &Node| -> Vec<f64> {
            let values = node.state.iter().zip(&self.start);
            values.map(|(value, start)| value - start).collect()
        };
        let mut rest: Vec<Vec<f64>> = self.nodes.iter().map(left).collect();
        let halves: Vec<f64> = states.clone().map(|j| half(&rest, j)).collect();
        let mut misses = Vec::new();
        for order in 0..=highest {
            let parts = self.amplitudes(order);
            // The mean stands in its summand twice.
            let share = if order == 0 { 0.5 } else { 1.0 };
            for (node, rest) in self.nodes.iter().zip(&mut rest) {
                let turned = Complex::from_polar(share, self.angle(node) * order as f64);
                for (rest, part) in rest.iter_mut().zip(&parts) {
                    *rest -= (part * turned).re;
                }
            }
            let miss = |j: usize| {
                let rounding = ROUNDING * self.start[j].abs();
                let worst = rest
                    .iter()
                    .fold(0.0_f64, |most, one| most.max(one[j].abs()));
                let counts = halves[j] > rounding && Some(j) != self.phase;
                if counts { worst / halves[j] } else { 0.0 }
            };
            misses.push(states.clone().map(miss).collect());
        }
        misses
    }
}

/// Half the extent of a state.
fn half(values: &[Vec<f64>], j: usize) -> f64 {
    let ends = values
        .iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |ends, one| {
            [ends[0].min(one[j]), ends[1].max(one[j])]
        });
    (0.5 * (ends[1] - ends[0])).max(0.0)
}

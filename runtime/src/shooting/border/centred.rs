//! What swings about the middle of its bounds, on a border: this is sought among the orbits along which it does.

use nalgebra::{DMatrix, DVector};

use super::problem::BorderProblem;
use super::sheet::Sheet;
use crate::continuation::correct_at;
use crate::linear::solved;
use crate::motion::Family;

/// By how much what is held is moved to tell what that does, over its usual magnitude.
const MOVED: f64 = 1e-4;
/// Steps of Newton's method with the first slopes.
const STEPS: usize = 4;

/// The border from which this one differs in the values alone of what is held, which are to swing about the middle, and what
/// is left of that in r; `None` if there is none.
pub(super) fn centred(
    problem: &mut BorderProblem<Family>,
    z: DVector<f64>,
    accuracy: f64,
) -> Option<(DVector<f64>, f64)> {
    let pins = problem.runs.pins.iter().enumerate();
    let swings: Vec<usize> = pins.filter_map(|(k, pin)| pin.centred.map(|_| k)).collect();
    if swings.is_empty() {
        return Some((z, 0.0));
    }
    let last = z.len() - 1;
    let mut off = problem.off_middle(&z, &swings)?;
    let mut slopes = DMatrix::zeros(swings.len(), swings.len());
    let mut by_r = DVector::zeros(swings.len());
    for (column, &k) in swings.iter().enumerate() {
        let value = problem.runs.pins[k].value;
        let moved = MOVED * problem.runs.pins[k].unit(&problem.magnitude);
        problem.runs.pins[k].value = value + moved;
        let there = correct_at(problem, z.clone(), 0.0, accuracy).ok()?.z;
        let slope = (problem.off_middle(&there, &swings)? - &off) / moved;
        slopes.set_column(column, &slope);
        by_r[column] = (there[last] - z[last]) / moved;
        problem.runs.pins[k].value = value;
    }
    let mut at = z;
    let mut left = solved(&slopes, &-&off)?;
    for _ in 0..STEPS {
        for (&k, by) in swings.iter().zip(left.iter()) {
            problem.runs.pins[k].value += by;
        }
        at = correct_at(problem, at, 0.0, accuracy).ok()?.z;
        off = problem.off_middle(&at, &swings)?;
        left = solved(&slopes, &-&off)?;
        if by_r.dot(&left).abs() <= accuracy * at[last].abs() {
            break;
        }
    }
    let moved = by_r.dot(&left).abs();
    Some((at, moved))
}

impl BorderProblem<Family> {
    /// How far what is held swings off the middle of its bounds, twice.
    fn off_middle(&mut self, z: &DVector<f64>, swings: &[usize]) -> Option<DVector<f64>> {
        let order = z.len() - 2;
        let flow = self.sheet.along_p(0.0).at(z[order + 1]).ok()?;
        let state = &z.as_slice()[..order];
        let start = self.round(&*flow, state, z[order]).ok()?.out.0;
        let shot = self.shot(&*flow, z, &start, &self.runs).ok()?;
        let off = |&k: &usize| {
            let turns = self.runs.pins[k].centred?.turns(&*flow, &shot).ok()?;
            Some(turns[0].value + turns[1].value)
        };
        let off: Option<Vec<f64>> = swings.iter().map(off).collect();
        Some(DVector::from_vec(off?))
    }
}

//! Motions as they are drawn: smooth lines along the rates of their states, with a corner where those jump.

use super::Curve;
use crate::study::Trajectory;

/// What one axis shows of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Coordinate {
    /// The time.
    Time,
    /// The state of this number.
    State(usize),
}

impl Coordinate {
    fn value(self, time: f64, state: &[f64]) -> f64 {
        match self {
            Self::Time => time,
            Self::State(index) => state.get(index).copied().unwrap_or(f64::NAN),
        }
    }
}

/// A motion as a line; of one with too many rows for its rates, straight from row to row.
pub fn traced(
    label: impl Into<String>,
    series: usize,
    motion: &Trajectory,
    plane: [Coordinate; 2],
) -> Curve {
    let place = |(time, state): (&f64, &Vec<f64>)| plane.map(|one| one.value(*time, state));
    let rows = motion.times.iter().zip(&motion.states);
    if motion.rates.len() != motion.times.len() {
        return Curve::line(label, series, rows.map(place).collect());
    }
    let (mut points, mut directions, mut times) = (Vec::new(), Vec::new(), Vec::new());
    for (row, rates) in rows.zip(&motion.rates) {
        let [comes, goes] = rates
            .each_ref()
            .map(|rates| plane.map(|one| one.value(1.0, rates)));
        let corner = (comes != goes).then_some(goes);
        for direction in [Some(comes), corner].into_iter().flatten() {
            times.push(*row.0);
            points.push(place(row));
            directions.push(direction);
        }
    }
    Curve::smooth(label, series, points)
        .directed(directions)
        .timed(times)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn where_rates_jump_there_is_a_corner() {
        let motion = Trajectory {
            times: vec![0.0, 1.0],
            states: vec![vec![0.0], vec![2.0]],
            rates: vec![[vec![2.0], vec![2.0]], [vec![2.0], vec![-1.0]]],
            ..Trajectory::default()
        };
        let curve = traced("", 0, &motion, [Coordinate::Time, Coordinate::State(0)]);
        assert_eq!(curve.points, [[0.0, 0.0], [1.0, 2.0], [1.0, 2.0]]);
        assert_eq!(curve.directions, [[1.0, 2.0], [1.0, 2.0], [1.0, -1.0]]);
        let long = Trajectory {
            rates: Vec::new(),
            ..motion
        };
        let curve = traced("", 0, &long, [Coordinate::Time, Coordinate::State(0)]);
        assert_eq!((curve.points.len(), curve.directions.len()), (2, 0));
    }
}

//! How far the copy's orbit lies from the exact one.
//!
//! The start of a lap moves by (I − Φ)⁻¹ q. Along neutral directions I − Φ is singular: where a body may stand anywhere, the copy
//! gains in a lap what it does, and what never changes along the exact orbit may drift. Each such direction takes one unknown
//! more, how much that is, and as one equation more the condition c·x = b that holds the copy, too.

use nalgebra::{DMatrix, DVector};

use super::PredictError;
use super::history::History;
use super::response::Response;
use crate::field::exact::Mode;
use crate::shooting::{Orbit, Pin};

/// Rate of a state at its extremum, in units of its magnitude per period, above which it has a corner there.
const CORNER: f64 = 1e-4;
/// Share of how far off a state is elsewhere below which it is not off at all.
const NOTHING: f64 = 1e-9;

/// Where the copy begins its lap, and how much longer that takes.
pub(super) struct Shift {
    pub(super) start: Vec<f64>,
    pub(super) period: f64,
}

impl Shift {
    /// The fixed point moves by (I − DP)⁻¹ q_P; bordered by the field, which gives the period as well, and by the pins.
    pub(super) fn of(
        history: &History,
        readings: &[Response],
        orbit: &Orbit,
    ) -> Result<Self, PredictError> {
        let last = readings.last().ok_or(PredictError::Singular)?;
        let n = last.velocity.len();
        let borders = borders(history, last, orbit);
        let order = n + borders.len();
        let matrix = DMatrix::from_fn(order, order, |i, j| match (i < n, j < n) {
            (true, true) => last.tangent[i][j] - f64::from(i == j),
            (true, false) => borders[j - n].column[i],
            (false, true) => borders[i - n].row[j],
            (false, false) => 0.0,
        });
        let mut right = DVector::zeros(order);
        for (i, value) in last.deviation.iter().enumerate() {
            right[i] = -value;
        }
        let solution = matrix.lu().solve(&right);
        let solution = solution.filter(|all| all.iter().all(|value| value.is_finite()));
        let solution = solution.ok_or(PredictError::Singular)?;
        Ok(Self {
            start: solution.rows(0, n).iter().copied().collect(),
            period: solution[n] * history.period,
        })
    }

    /// Relative error of the largest magnitude of state j, reached at `time`.
    pub(super) fn peak(
        &self,
        history: &History,
        readings: &[Response],
        (j, time): (usize, f64),
        orbit: &Orbit,
    ) -> Option<f64> {
        let at = readings
            .iter()
            .find(|r| r.time == time || time == 0.0 && r.time == history.period)?;
        let corner =
            (at.velocity[j] * history.period).abs() > CORNER * (orbit.max[j] - orbit.min[j]);
        let near = |t: f64| (t - time).abs() < 1e-9 * history.period;
        let turned = !corner || self.ends_lap(history, (j, time), orbit);
        let told = history.drive.is_some() || !is_free(orbit, j);
        if !(turned && told) || history.switches.iter().any(|s| near(s.event.time)) {
            return None;
        }
        if self.is_bound(history, readings, (j, at)) {
            return None;
        }
        let error = if time == 0.0 {
            self.start[j] / history.start.state[j]
        } else {
            self.moved(at, j) / at.state[j]
        };
        error.is_finite().then_some(error)
    }

    /// How far off the copy has state j there.
    fn moved(&self, at: &Response, j: usize) -> f64 {
        let row = at.tangent[j].iter().zip(&self.start);
        row.map(|(t, d)| t * d).sum::<f64>() + at.deviation[j]
    }

    /// Whether that is nothing but rounding because a contact sticks that does not pull: what is of higher order decides.
    fn is_bound(
        &self,
        history: &History,
        readings: &[Response],
        (j, at): (usize, &Response),
    ) -> bool {
        let modes = history.passage.modes_within(at.time);
        let sticks = modes.is_some_and(|modes| modes.contains(&Mode::Stick));
        let all = readings.iter().map(|at| self.moved(at, j).abs());
        sticks && self.moved(at, j).abs() <= NOTHING * all.fold(0.0, f64::max)
    }

    /// Whether that is an end of a lap that a drive times, of a state that runs on: it need not turn there.
    fn ends_lap(&self, history: &History, (j, time): (usize, f64), orbit: &Orbit) -> bool {
        let end = time == 0.0 || time == history.period;
        end && history.drive.is_some() && orbit.runs(j)
    }
}

/// Whether a state may be anywhere: then what is told of it depends on where the lap begins.
fn is_free(orbit: &Orbit, j: usize) -> bool {
    let mut ways = orbit.pins.iter().filter_map(Pin::along);
    ways.any(|way| way[j] != 0.0)
}

/// An unknown besides the start, by what it enters the equations, and the equation besides.
struct Border {
    column: Vec<f64>,
    row: Vec<f64>,
}

fn borders(history: &History, last: &Response, orbit: &Orbit) -> Vec<Border> {
    let period = Border {
        column: last.velocity.iter().map(|f| f * history.period).collect(),
        row: begins(history, last, orbit),
    };
    let neutral = orbit.pins.iter().map(|pin| Border {
        // What never changes is the left vector to its own direction.
        column: pin.along().unwrap_or(&pin.combination).to_vec(),
        row: pin.combination.clone(),
    });
    std::iter::once(period).chain(neutral).collect()
}

/// What does not change of the start: it moves across the field; of a lap that is held where it begins, the phase of the drive.
fn begins(history: &History, last: &Response, orbit: &Orbit) -> Vec<f64> {
    let held = orbit.shift.is_some() || !orbit.pins.is_empty();
    match history.drive.filter(|_| held) {
        Some(phase) => (0..last.velocity.len())
            .map(|j| f64::from(j == phase))
            .collect(),
        None => last.velocity.clone(),
    }
}

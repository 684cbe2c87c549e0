//! The crossings of a motion within a time, or once around an orbit.

use super::crossing::Crossing;
use super::crossings::Crossings;
use super::horizon::Horizon;
use super::section::{Direction, Section};
use crate::flow::FlowError;
use crate::motion::{Flow, Place};

/// Share of a period by which a start may be off the section that it lies on.
const INSTANT: f64 = 1e-6;
/// Share of a period after which a turn at its end is sure to be one.
const AFTER: f64 = 0.1;

/// What a motion has met, and how far it went.
#[derive(Debug, Clone, PartialEq)]
pub struct Met {
    /// The crossings that count, in the order of time.
    pub points: Vec<Crossing>,
    /// How many there were in the other direction.
    pub against: usize,
    /// How long it was watched.
    pub time: f64,
    /// Smallest value of each state in that time; 0 of the phase of a drive.
    pub low: Vec<f64>,
    /// Largest value of each state; 2π of the phase of a drive.
    pub high: Vec<f64>,
}

impl Met {
    fn new(
        section: Section,
        all: Vec<Crossing>,
        time: f64,
        (low, high): (Vec<f64>, Vec<f64>),
    ) -> Self {
        let counts = |crossing: &Crossing| section.direction.admits(crossing.rising);
        let (points, others): (Vec<_>, Vec<_>) = all.into_iter().partition(counts);
        Self {
            points,
            against: others.len(),
            time,
            low,
            high,
        }
    }
}

/// The crossings of the motion from `place` up to the time `time`.
///
/// # Errors
/// The motion cannot be followed.
pub fn until(flow: &dyn Flow, place: Place, section: Section, time: f64) -> Result<Met, FlowError> {
    let all = Section {
        direction: Direction::Both,
        ..section
    };
    let mut crossings = Crossings::new(flow, place, all, Horizon::Time(time))?;
    let met = crossings.by_ref().collect::<Result<Vec<Crossing>, _>>()?;
    let (low, high) = crossings.range();
    Ok(Met::new(section, met, time, (low, high)))
}

/// The crossings of the periodic orbit through `place` in one period, each once; their number is the
/// n of a period-n motion.
///
/// # Errors
/// The motion cannot be followed.
pub fn once_around(
    flow: &dyn Flow,
    place: Place,
    section: Section,
    period: f64,
) -> Result<Met, FlowError> {
    let near = INSTANT * period;
    let all = Section {
        direction: Direction::Both,
        ..section
    };
    let Met {
        mut points,
        low,
        high,
        ..
    } = until(flow, place, all, (1.0 + AFTER) * period)?;
    // A start on the section is met at the end, not at the beginning.
    points.retain(|crossing| crossing.time > near && crossing.time <= period + near);
    Ok(Met::new(section, points, period, (low, high)))
}

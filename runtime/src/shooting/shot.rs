//! The motion once around, as far as shooting follows it.

use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector};

use super::division::Division;
use super::pin::Pin;
use crate::flow::{Determinant, FlowError};
use crate::motion::{
    Event, Extremum, Factor, Flow, Modes, Passage, Place, Segment as Stretch, Velocity,
    half_extents, is_still,
};

/// Whether two times are the same instant of a period.
pub(super) const INSTANT: f64 = 1e-6;
/// One evaluation of the problem: the motion once around.
#[derive(Debug, Clone)]
pub struct Shot {
    /// One passage for each segment.
    pub passages: Vec<Passage>,
    /// Where the first begins.
    pub start: Place,
    /// The field there.
    pub velocity: Velocity,
    /// The period tried.
    pub period: f64,
    /// When each segment begins.
    pub begins: Vec<f64>,
    /// The state that is the phase of a drive, if there is one.
    pub drive: Option<usize>,
    /// How far its end is from its start, relative to the extents of the states.
    pub closure: f64,
    /// What is held in neutral directions.
    pub pins: Vec<Pin>,
    /// What the states gain once around a motion that runs on.
    pub shift: Option<Vec<f64>>,
}

/// A swing below this share of a state is measured as if it were that: what a small part of it may be off by is rounding.
const SWING: f64 = 1e-5;

/// Half the extent of each state; `fallback` where it has none. Where states gain a shift once around, they swing about what
/// they gain, and others about what makes them gain it: their largest magnitudes count then, and radians of the shift, or how
/// far they swing besides.
pub(super) fn usual(
    low: &[f64],
    high: &[f64],
    shift: Option<&[f64]>,
    fallback: &[f64],
) -> Vec<f64> {
    let Some(shift) = shift else {
        let size = |j: usize| low[j].abs().max(high[j].abs());
        let halves = half_extents(low, high, fallback).into_iter().enumerate();
        let swing = |(j, half): (usize, f64)| {
            let half = match is_still(half, size(j)) {
                true => fallback[j].min(size(j)),
                false => half,
            };
            half.max(SWING * size(j))
        };
        return halves.map(swing).collect();
    };
    let widest = |j: usize| match shift[j] {
        0.0 => low[j].abs().max(high[j].abs()),
        gain => {
            let gain = gain.abs();
            (gain / TAU).max(0.5 * (high[j] - low[j] - gain))
        }
    };
    let wide: Vec<f64> = (0..low.len()).map(widest).collect();
    let below: Vec<f64> = wide.iter().map(|size| -size).collect();
    half_extents(&below, &wide, fallback)
}

/// Of states that are shifted together, those that keep still beside others are measured as they are.
fn level(sizes: &mut [f64], direction: &[f64]) {
    let shifted = || direction.iter().map(|d| d.abs()).enumerate();
    let moved = shifted().filter(|(_, d)| *d > 0.0);
    let largest = moved.map(|(j, d)| sizes[j] / d).fold(0.0, f64::max);
    for (j, d) in shifted() {
        if is_still(sizes[j], largest * d) {
            sizes[j] = largest * d;
        }
    }
}

/// Most places at which an orbit is begun anew.
const OTHERS: usize = 4;
/// How far from where contacts switch, over the period.
const CLEAR: f64 = 1e-3;

impl Shot {
    /// States and modes in which the motion may begin as well: where the first state is least or greatest, or where others are, but
    /// not where contacts switch, at which rounding would tell its modes; none where it is divided into segments.
    pub(super) fn turns(&self) -> Vec<(Vec<f64>, Modes)> {
        let [passage] = self.passages.as_slice() else {
            return Vec::new();
        };
        let calm = || {
            let turns = passage.extrema.iter();
            turns.filter(|turn| !self.switches_near(turn.time, CLEAR))
        };
        let first = |maximum| calm().filter(move |turn| turn.index == 0 && turn.maximum == maximum);
        let [low, high] = [false, true].map(|maximum| first(maximum).take(OTHERS / 2));
        let other = calm().filter(|turn| turn.index != 0);
        let turns = low.chain(high).chain(other).take(OTHERS);
        let place = |turn: &Extremum| {
            let modes = passage.modes_within(turn.time)?;
            Some((turn.state.clone(), modes.clone()))
        };
        turns.filter_map(place).collect()
    }

    /// Whether it runs through the same modes by the same impacts.
    pub(super) fn passes_like(&self, other: &Self) -> bool {
        let [own, theirs] = [self, other].map(|shot| {
            let all = shot.passages.iter().flat_map(|passage| &passage.segments);
            all.map(|one| (&one.modes, one.impact))
        });
        own.eq(theirs)
    }

    /// How often its modes change or it is hit, wherever it begins.
    pub(super) fn changes(&self) -> usize {
        let within = |passage: &Passage| passage.segments.len().saturating_sub(1);
        self.passages.iter().map(within).sum()
    }

    /// Smallest and largest value of each state along the motion.
    ///
    /// The ends of steps count too: in a layer so stiff that a rate is all rounding error, no extremum shows.
    #[must_use]
    pub fn extent(&self) -> (Vec<f64>, Vec<f64>) {
        let (mut low, mut high) = match self.passages.first() {
            Some(first) => (first.calm.low.clone(), first.calm.high.clone()),
            None => (self.start.state.clone(), self.start.state.clone()),
        };
        for passage in &self.passages {
            for extremum in &passage.extrema {
                let (j, value) = (extremum.index, extremum.state[extremum.index]);
                low[j] = low[j].min(value);
                high[j] = high[j].max(value);
            }
            for j in 0..low.len() {
                low[j] = low[j].min(passage.calm.low[j]);
                high[j] = high[j].max(passage.calm.high[j]);
            }
        }
        if let Some(phase) = self.drive {
            (low[phase], high[phase]) = (0.0, TAU);
        }
        (low, high)
    }

    /// Half the extent of each state; `fallback` where it has none.
    pub(crate) fn magnitude(&self, fallback: &[f64]) -> Vec<f64> {
        let (low, high) = self.extent();
        let mut sizes = usual(&low, &high, self.shift.as_deref(), fallback);
        for direction in self.pins.iter().filter_map(Pin::along) {
            level(&mut sizes, direction);
        }
        sizes
    }

    /// The factors of Φ once around, if they were wanted.
    pub(super) fn factors(&self) -> Vec<Factor> {
        let derivatives = self
            .passages
            .iter()
            .filter_map(|passage| passage.derivatives.as_ref());
        derivatives
            .flat_map(|derivatives| derivatives.factors.iter().cloned())
            .collect()
    }

    /// The segments of the orbit with these unknowns; `None` if it is not divided.
    pub(super) fn division(&self, z: &DVector<f64>) -> Option<Division> {
        let order = self.start.state.len();
        let ends = self.passages.iter().map(|passage| &passage.end.modes);
        let modes = std::iter::once(&self.start.modes).chain(ends);
        let start = |(i, modes): (usize, &Modes)| Place {
            state: z.rows(i * order, order).iter().copied().collect(),
            modes: modes.clone(),
        };
        let ends = self.begins.iter().skip(1).chain([&self.period]);
        let shares = self.begins.iter().zip(ends);
        let count = self.passages.len();
        (count > 1).then(|| Division {
            starts: modes.take(count).enumerate().map(start).collect(),
            shares: shares
                .map(|(begin, end)| (end - begin) / self.period)
                .collect(),
        })
    }

    /// How far rounding at its events may have put a state off, in usual magnitudes.
    pub(super) fn rounding(&self) -> f64 {
        let passages = self.passages.iter();
        passages.map(|passage| passage.rounding).fold(0.0, f64::max)
    }

    /// What happened at the contacts once around.
    pub(super) fn events(&self) -> Vec<Event> {
        let passages = self.passages.iter().zip(&self.begins);
        let later = |(passage, begin): (&Passage, &f64)| {
            let events = passage.events.clone().into_iter();
            let begin = *begin;
            events.map(move |event| Event {
                time: begin + event.time,
                ..event
            })
        };
        passages.flat_map(later).collect()
    }

    /// Stretches in constant mode once around.
    pub(super) fn stretches(&self) -> Vec<Stretch> {
        let mut joined: Vec<Stretch> = Vec::new();
        for passage in &self.passages {
            let mut stretches = passage.segments.clone().into_iter();
            match (joined.last_mut(), stretches.next()) {
                (Some(last), Some(first))
                    if last.modes == first.modes && first.impact.is_none() =>
                {
                    last.duration += first.duration;
                }
                (_, first) => joined.extend(first),
            }
            joined.extend(stretches);
        }
        joined
    }

    /// Whether a contact switches within this share of the period from a time, in a motion of one segment.
    pub(super) fn switches_near(&self, time: f64, share: f64) -> bool {
        let near = |event: &Event| {
            let turns = (event.time - time) / self.period;
            event.switches() && (turns - turns.round()).abs() < share
        };
        match self.passages.as_slice() {
            [passage] => passage.events.iter().any(near),
            _ => false,
        }
    }

    /// Whether a time is that of the start.
    pub(super) fn is_start(&self, time: f64) -> bool {
        let turns = time / self.period;
        (turns - turns.round()).abs() <= INSTANT
    }

    /// Whether a contact switches at that very time: the mode in which a motion comes back then is one of rounding.
    pub(super) fn switches_at(&self, time: f64) -> bool {
        self.switches_near(time, INSTANT)
    }

    /// Φ once around, and its determinant.
    pub(crate) fn monodromy(&self) -> (DMatrix<f64>, Determinant) {
        let order = self.start.state.len();
        let mut phi = DMatrix::identity(order, order);
        let mut determinant = Determinant::ONE;
        for derivatives in self
            .passages
            .iter()
            .filter_map(|passage| passage.derivatives.as_ref())
        {
            phi = &derivatives.state * phi;
            determinant = determinant.times(derivatives.determinant);
        }
        (phi, determinant)
    }

    /// What the states gain in this part of the period.
    pub(super) fn gain(&self, time: f64) -> Option<Vec<f64>> {
        let share = time / self.period;
        let gain = |shift: &Vec<f64>| shift.iter().map(|gain| share * gain).collect();
        self.shift.as_ref().map(gain)
    }

    /// The segment in which a time in the period lies.
    pub(super) fn segment(&self, time: f64) -> usize {
        self.begins.partition_point(|begin| *begin <= time).max(1) - 1
    }

    /// The place of a state on the way, at a time in the period.
    ///
    /// # Errors
    /// The flow has no place there.
    pub(super) fn place(
        &self,
        flow: &dyn Flow,
        time: f64,
        state: &[f64],
    ) -> Result<Place, FlowError> {
        let segment = self.segment(time);
        let modes = self.passages[segment].modes_within(time - self.begins[segment]);
        Place::known(flow, state, modes)
    }
}

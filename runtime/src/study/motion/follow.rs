//! A motion of any length, followed stretch by stretch, so that no more of it is in memory than is kept.

use std::ops::ControlFlow;

use super::sized::Sized;
use crate::field::Work;
use crate::field::exact::Mode;
use crate::flow::{FlowError, Peaks, Want};
use crate::motion::{Family, Flow, Modes, Passage, Place, Segment};
use crate::poincare::longest;

/// Numbers in the samples of a stretch.
const NUMBERS: usize = 1 << 17;
/// Samples that a stretch has at least.
const LEAST: usize = 64;
/// Share of a time that is rounding.
const INSTANT: f64 = 4.0 * f64::EPSILON;

/// A point of a motion that can be read.
#[derive(Clone, Copy)]
pub(super) struct Point<'a> {
    flow: &'a dyn Flow,
    state: &'a [f64],
    modes: &'a Modes,
    /// The modes in which the motion comes here, and those in which it goes on; none on the side of an impact.
    sides: [Option<&'a Modes>; 2],
    /// How far the phase of a drive has turned before.
    turned: f64,
    pub(super) time: f64,
}

impl Point<'_> {
    /// The value of each state; the phase of a drive grows.
    pub(super) fn values(&self) -> impl Iterator<Item = f64> {
        let phase = self.flow.phase();
        let values = self.state.iter().enumerate();
        values.map(move |(j, value)| value + if phase == Some(j) { self.turned } else { 0.0 })
    }

    /// The rates of the states, as the motion comes and as it goes on; NaN where they are not determined, and on the side
    /// of an impact.
    pub(super) fn rates(&self) -> [Vec<f64>; 2] {
        self.sides.map(|modes| {
            let velocity = modes.and_then(|modes| self.flow.velocity(&self.place(modes)).ok());
            velocity.map_or_else(
                || vec![f64::NAN; self.state.len()],
                |velocity| velocity.f.as_slice().to_vec(),
            )
        })
    }

    fn place(&self, modes: &Modes) -> Place {
        Place {
            state: self.state.to_vec(),
            modes: modes.clone(),
        }
    }

    /// All that is known there.
    pub(super) fn row(&self) -> Result<Row, FlowError> {
        let (forces, observables) = self.flow.read(&self.place(self.modes))?;
        Ok(Row {
            time: self.time,
            state: self.values().collect(),
            observables,
            forces,
        })
    }
}

/// All that is known of a motion at one time.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Row {
    pub(super) time: f64,
    pub(super) state: Vec<f64>,
    pub(super) observables: Vec<f64>,
    pub(super) forces: Vec<f64>,
}

/// A stretch of a motion.
pub(super) struct Stretch<'a> {
    flow: &'a dyn Flow,
    from: &'a Place,
    passage: &'a Passage,
    turned: f64,
    /// When it began.
    pub(super) since: f64,
    /// When it ended.
    pub(super) until: f64,
}

impl Stretch<'_> {
    pub(super) fn work(&self) -> Work {
        self.passage.work
    }

    /// Where it was sampled, in the order of time; where one begins that was not the first, the one before has ended.
    pub(super) fn samples(&self) -> impl Iterator<Item = Point<'_>> {
        let known = usize::from(self.since > 0.0);
        let path = self.passage.path.iter().skip(known);
        self.points(path.map(|sample| (sample.time, &*sample.state)))
    }

    /// Where a state was extremal, in the order of time.
    pub(super) fn extrema(&self) -> impl Iterator<Item = Point<'_>> {
        let extrema = self.passage.extrema.iter();
        self.points(extrema.map(|one| (one.time, &*one.state)))
    }

    fn points<'s>(
        &'s self,
        places: impl Iterator<Item = (f64, &'s [f64])>,
    ) -> impl Iterator<Item = Point<'s>> {
        let mut clock = Clock::new(&self.passage.segments);
        places.map(move |(time, state)| {
            let sides = clock.sides(time);
            Point {
                flow: self.flow,
                state,
                modes: clock.modes().unwrap_or(&self.from.modes),
                sides,
                turned: self.turned,
                time: self.since + time,
            }
        })
    }
}

/// Follows the motion of the flow at r from a state, reached in these modes, for `time`, or until `see` wants no more.
///
/// # Errors
/// The motion cannot be followed, or `see` fails.
pub(super) fn follow(
    (family, r): (&Family, f64),
    (start, modes): (&[f64], &[Mode]),
    time: f64,
    see: &mut dyn FnMut(&Stretch<'_>) -> Result<ControlFlow<()>, FlowError>,
) -> Result<(), FlowError> {
    let want = Want {
        extrema: Peaks::All,
        path: true,
        samples: (NUMBERS / start.len().max(1)).max(LEAST),
        ..Want::default()
    };
    let mut sized = Sized::new(family, r)?;
    let mut place = sized.flow.place_in(start, modes)?;
    let most = longest(sized.flow.as_ref(), &place)?;
    let (mut since, mut turned) = (0.0, 0.0);
    loop {
        let passage = sized.advance(&place, (time - since).min(most), want);
        let passage = passage.map_err(|error| error.later(since))?;
        let flow = sized.flow.as_ref();
        let until = since + passage.time;
        let over = time - until <= INSTANT * time;
        let stretch = Stretch {
            flow,
            from: &place,
            passage: &passage,
            turned,
            since,
            until: if over { time } else { until },
        };
        if see(&stretch)?.is_break() || over {
            return Ok(());
        }
        let unwrapped = passage.end.state.clone();
        place = Place {
            state: flow.wrapped(passage.end.state),
            ..passage.end
        };
        if let Some(phase) = flow.phase() {
            turned += unwrapped[phase] - place.state[phase];
        }
        since = until;
    }
}

/// The flow at r, its errors measured against how large the states are in the beginning of the motion from a state,
/// reached in these modes.
///
/// # Errors
/// The motion cannot be followed.
pub(super) fn measured(
    (family, r): (&Family, f64),
    (start, modes): (&[f64], &[Mode]),
    time: f64,
) -> Result<Box<dyn Flow>, FlowError> {
    let sized = Sized::new(family, r)?;
    let place = sized.flow.place_in(start, modes)?;
    let most = longest(sized.flow.as_ref(), &place)?;
    sized.learned(&place, time.min(most))
}

/// Tells the modes of a motion at times that only grow.
struct Clock<'a> {
    segments: &'a [Segment],
    /// When the first of them ends.
    end: f64,
    /// When it was asked last.
    asked: f64,
}

impl<'a> Clock<'a> {
    fn new(segments: &'a [Segment]) -> Self {
        let end = segments.first().map_or(0.0, |segment| segment.duration);
        Self {
            segments,
            end,
            asked: f64::NEG_INFINITY,
        }
    }

    /// Those now.
    fn modes(&self) -> Option<&'a Modes> {
        self.segments.first().map(|segment| &segment.modes)
    }

    /// Those before and after a time, no earlier than the last one: none on the side of an impact, whose instant is asked for
    /// twice, before it and after it.
    fn sides(&mut self, time: f64) -> [Option<&'a Modes>; 2] {
        while time > self.end && self.segments.len() > 1 {
            self.pass();
        }
        let ends = self.end - time <= INSTANT * self.end;
        let next = self.segments.get(1).filter(|_| ends);
        let struck = next.is_some_and(|next| next.impact.is_some());
        let after = struck && time == self.asked;
        self.asked = time;
        match next {
            Some(_) if after => {
                self.pass();
                [None, self.modes()]
            }
            Some(_) if struck => [self.modes(), None],
            Some(next) => [self.modes(), Some(&next.modes)],
            None => [self.modes(); 2],
        }
    }

    fn pass(&mut self) {
        self.segments = &self.segments[1..];
        self.end += self.segments[0].duration;
    }
}

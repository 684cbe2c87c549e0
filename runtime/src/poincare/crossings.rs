//! The crossings of a section, one after the other.

use std::collections::VecDeque;

use serde::Serialize;

use super::radian;
use super::section::{Section, Surface};
use super::turns::Turns;
use crate::field::Work;
use crate::flow::{FlowError, Want};
use crate::motion::{Extremum, Flow, Passage, Place};

/// Passages without a crossing, each twice as long as the one before, after which no more are awaited.
const SILENCE: u32 = 12;
/// Crossings in a passage that suffice: it need not be longer.
const ENOUGH: usize = 2;
/// A state this close to a level, in units of its rounding, lies on it.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
const ITERATIONS: usize = 80;

/// A point where a motion crosses a section.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Crossing {
    /// When, from the beginning of the motion.
    pub time: f64,
    /// Whether the function that vanishes there grows.
    pub rising: bool,
    /// Where.
    pub state: Vec<f64>,
}

/// The crossings of a motion with a section, in the order of time; an iterator over them.
///
/// It ends when the motion has crossed nothing for a long time, as one that has come to rest. A
/// motion that begins on the section has not crossed it.
pub struct Crossings<'f> {
    flow: &'f dyn Flow,
    section: Section,
    place: Place,
    time: f64,
    chunk: f64,
    silent: u32,
    ready: VecDeque<Crossing>,
    turns: Turns,
    /// Sign of the state less its level where it was last not zero.
    side: f64,
    low: Vec<f64>,
    high: Vec<f64>,
    /// Work of all passages.
    pub work: Work,
}

impl<'f> Crossings<'f> {
    /// From `place` on.
    ///
    /// # Errors
    /// The field is not finite there.
    pub fn new(flow: &'f dyn Flow, place: Place, section: Section) -> Result<Self, FlowError> {
        let side = match section.surface {
            Surface::Level { state, value } => side(&place.state, state, value),
            Surface::Rate(_) => 0.0,
        };
        Ok(Self {
            flow,
            section,
            time: 0.0,
            chunk: radian(flow, &place)?,
            silent: 0,
            ready: VecDeque::new(),
            turns: Turns::of(section.surface.state()),
            side,
            low: place.state.clone(),
            high: place.state.clone(),
            place,
            work: Work::default(),
        })
    }

    /// How far the motion has been followed: at least to the last crossing.
    #[must_use]
    pub fn place(&self) -> (f64, Place) {
        (self.time, self.place.clone())
    }

    /// Smallest and largest value of each state since the beginning, or since the last [`Crossings::forget`].
    #[must_use]
    pub fn range(&self) -> (Vec<f64>, Vec<f64>) {
        (self.low.clone(), self.high.clone())
    }

    /// Forgets the range, to measure it anew from here.
    pub fn forget(&mut self) {
        self.low.clone_from(&self.place.state);
        self.high.clone_from(&self.place.state);
    }

    /// Follows the motion for one more passage, whether it crosses or not.
    ///
    /// # Errors
    /// The motion cannot be followed.
    pub fn watch_on(&mut self) -> Result<(), FlowError> {
        self.follow()
    }

    /// Follows one more passage.
    fn follow(&mut self) -> Result<(), FlowError> {
        let passage = self.flow.advance(&self.place, self.chunk, Want::EXTREMA)?;
        self.work += passage.work;
        let before = self.ready.len();
        match self.section.surface {
            Surface::Rate(_) => self.turn(&passage),
            Surface::Level { state, value } => self.cross(&passage, state, value)?,
        }
        self.widen(&passage);
        self.place = passage.end;
        self.time += self.chunk;
        let found = self.ready.len() - before;
        self.silent = if found > 0 { 0 } else { self.silent + 1 };
        if found < ENOUGH {
            self.chunk *= 2.0;
        }
        Ok(())
    }

    /// Where the state is extremal, its rate vanishes.
    fn turn(&mut self, passage: &Passage) {
        for extremum in &passage.extrema {
            let absolute = Extremum {
                time: self.time + extremum.time,
                ..extremum.clone()
            };
            if let Some(turn) = self.turns.take(absolute) {
                self.note(Crossing {
                    time: turn.time,
                    state: turn.state,
                    rising: !turn.maximum,
                });
            }
        }
    }

    /// Between its extrema the state is monotonic: it meets a level at most once.
    fn cross(&mut self, passage: &Passage, state: usize, level: f64) -> Result<(), FlowError> {
        let extrema = passage.extrema.iter().filter(|e| e.index == state);
        let turns = extrema.map(|extremum| (extremum.time, &extremum.state));
        let stops = turns.chain([(self.chunk, &passage.end.state)]);
        let mut from = 0.0;
        for (until, there) in stops {
            let side = side(there, state, level);
            if side == 0.0 {
                continue;
            }
            if side * self.side < 0.0 {
                let (time, place) = self.meet(state, level, from, (until, there))?;
                self.note(Crossing {
                    time: self.time + time,
                    state: place,
                    rising: side > 0.0,
                });
            }
            self.side = side;
            from = until;
        }
        Ok(())
    }

    /// The time and state, between two times of the passage, at which the state has the level: by
    /// Newton's method on the motion itself, kept inside by halving.
    fn meet(
        &mut self,
        index: usize,
        level: f64,
        from: f64,
        until: (f64, &[f64]),
    ) -> Result<(f64, Vec<f64>), FlowError> {
        let mut low = (from, self.place.clone());
        if from > 0.0 {
            low.1 = self.ahead(&low.1, from)?;
        }
        let lack = |state: &[f64]| state[index] - level;
        let (mut high, mut best) = (until.0, (until.0, until.1.to_vec()));
        let rise = lack(&best.1).signum();
        let mut time = secant((low.0, lack(&low.1.state)), (high, lack(&best.1)));
        for _ in 0..ITERATIONS {
            if !(time > low.0 && time < high) {
                time = 0.5 * (low.0 + high);
            }
            if !(time > low.0 && time < high) {
                break;
            }
            let place = self.ahead(&low.1, time - low.0)?;
            let short = lack(&place.state);
            best = (time, place.state.clone());
            if side(&place.state, index, level) == 0.0 {
                break;
            }
            let slope = self.flow.velocity(&place)?.f[index];
            if short * rise < 0.0 {
                low = (time, place);
            } else {
                high = time;
            }
            time -= short / slope;
        }
        Ok(best)
    }

    fn ahead(&mut self, from: &Place, time: f64) -> Result<Place, FlowError> {
        let passage = self.flow.advance(from, time, Want::default())?;
        self.work += passage.work;
        Ok(passage.end)
    }

    fn note(&mut self, crossing: Crossing) {
        if self.section.direction.admits(crossing.rising) {
            self.ready.push_back(crossing);
        }
    }

    fn widen(&mut self, passage: &Passage) {
        let extrema = passage.extrema.iter().map(|extremum| &extremum.state);
        for state in extrema.chain([&passage.end.state]) {
            for (j, &value) in state.iter().enumerate() {
                self.low[j] = self.low[j].min(value);
                self.high[j] = self.high[j].max(value);
            }
        }
    }
}

/// Sign of a state less a level, 0 within rounding.
fn side(state: &[f64], index: usize, level: f64) -> f64 {
    let lack = state[index] - level;
    if lack.abs() <= ROUNDING * state[index].abs().max(level.abs()) {
        0.0
    } else {
        lack.signum()
    }
}

fn secant(low: (f64, f64), high: (f64, f64)) -> f64 {
    low.0 - low.1 * (high.0 - low.0) / (high.1 - low.1)
}

impl Iterator for Crossings<'_> {
    type Item = Result<Crossing, FlowError>;

    fn next(&mut self) -> Option<Self::Item> {
        while self.ready.is_empty() && self.silent < SILENCE {
            if let Err(error) = self.follow() {
                self.silent = SILENCE;
                return Some(Err(error));
            }
        }
        self.ready.pop_front().map(Ok)
    }
}

//! The crossings of a section, one after the other.

use std::collections::VecDeque;
use std::f64::consts::TAU;

use super::crossing::Crossing;
use super::horizon::{Horizon, Patience, Silence};
use super::level::Level;
use super::reach::Reach;
use super::section::{Section, Surface};
use super::turns::Turns;
use super::{longest, radian};
use crate::field::Work;
use crate::flow::{FlowError, Want};
use crate::motion::{Extremum, Flow, Passage, Place};

/// Crossings in a passage that suffice: it need not be longer.
const ENOUGH: usize = 2;
/// Steps in a passage that suffice.
const STEPS: u64 = 5_000;
/// A phase this close to that of the section, in radians, is on it.
const ON: f64 = 1e-12;

/// The crossings of a motion with a section, in the order of time; an iterator over them.
///
/// It ends with its [`Horizon`]. A motion that begins on the section has not crossed it. A section that is a phase of
/// the drive is met once in each of its turns.
pub struct Crossings<'f> {
    flow: &'f dyn Flow,
    section: Section,
    horizon: Horizon,
    place: Place,
    time: f64,
    chunk: f64,
    /// The longest one.
    longest: f64,
    ended: bool,
    ready: VecDeque<Crossing>,
    turns: Turns,
    /// The level, if the section is one.
    level: Option<Level>,
    reach: Reach,
    whole: Reach,
    /// How large the states usually are.
    usual: Vec<f64>,
    patience: Patience,
    /// Work of all passages.
    pub work: Work,
}

impl<'f> Crossings<'f> {
    /// From `place` on.
    ///
    /// # Errors
    /// The field is not finite there.
    pub fn new(
        flow: &'f dyn Flow,
        place: Place,
        section: Section,
        horizon: Horizon,
    ) -> Result<Self, FlowError> {
        let level = match section.surface {
            Surface::Level { state, value } => Some(Level::from(&place, state, value)),
            Surface::Rate(_) => None,
        };
        Ok(Self {
            flow,
            section,
            horizon,
            time: 0.0,
            chunk: radian(flow, &place)?,
            longest: longest(flow, &place)?,
            ended: false,
            ready: VecDeque::new(),
            turns: Turns::of(section.surface.state()),
            level,
            reach: Reach::at(&place.state),
            whole: Reach::at(&place.state),
            usual: vec![0.0; place.state.len()],
            patience: Patience::from(&place),
            place,
            work: Work::default(),
        })
    }

    /// The same of a motion whose states usually are this large: what moves next to nothing of that rests, though it has
    /// never moved more.
    #[must_use]
    pub fn among(mut self, usual: &[f64]) -> Self {
        self.usual = usual.to_vec();
        self
    }

    /// How far the motion has been followed: at least to the last crossing.
    #[must_use]
    pub fn place(&self) -> (f64, Place) {
        (self.time, self.place.clone())
    }

    /// Smallest and largest value of each state since the beginning, or since the last [`Crossings::forget`]; of the
    /// phase of a drive, 0 and 2π.
    #[must_use]
    pub fn range(&self) -> (Vec<f64>, Vec<f64>) {
        (self.reach.low.clone(), self.reach.high.clone())
    }

    /// How far apart the extremes of each state are since the beginning.
    #[must_use]
    pub fn extent(&self) -> Vec<f64> {
        let states = 0..self.place.state.len();
        states.map(|j| self.whole.extent(j)).collect()
    }

    /// Forgets the range, to measure it anew from here.
    pub fn forget(&mut self) {
        self.reach = Reach::at(&self.place.state);
    }

    /// The stretch without a crossing after which no more is awaited, once it has come to that.
    #[must_use]
    pub fn silence(&self) -> Option<Silence> {
        self.patience.silence()
    }

    /// Follows the motion for one more passage, whether it crosses or not.
    ///
    /// # Errors
    /// The motion cannot be followed.
    pub fn watch_on(&mut self) -> Result<(), FlowError> {
        self.follow()
    }

    fn is_over(&self) -> bool {
        let over = match self.horizon {
            Horizon::Time(time) => self.time >= time,
            Horizon::Recurrence => self.patience.end().is_some(),
        };
        self.ended || over
    }

    /// Follows one more passage.
    fn follow(&mut self) -> Result<(), FlowError> {
        let gap = self.gap()?;
        let (time, until) = self.next_stop(gap);
        let passage = self.flow.advance(&self.place, time, Want::EXTREMA)?;
        self.work += passage.work;
        let before = self.ready.len();
        match (&mut self.level, gap) {
            (None, _) => self.turn(&passage, until),
            (Some(_), Some(_)) => {}
            (Some(level), None) => {
                let (start, passage) = ((&self.place, self.time), (&passage, time));
                let found = level.crossings(self.flow, start, passage, &mut self.work)?;
                found.into_iter().for_each(|crossing| self.note(crossing));
            }
        }
        let mut end = passage.end.clone();
        end.state = self.flow.wrapped(end.state);
        if let (true, Surface::Level { state, value }) = (gap == Some(time), self.section.surface) {
            end.state[state] = value.rem_euclid(TAU) % TAU;
            self.note(Crossing {
                time: until,
                rising: true,
                state: end.state.clone(),
            });
        }
        self.place = end;
        self.watch(&passage, (time, until), before)
    }

    /// The time up to the next phase of the drive that is the section, if the section is one.
    fn gap(&self) -> Result<Option<f64>, FlowError> {
        let Surface::Level { state, value } = self.section.surface else {
            return Ok(None);
        };
        if self.flow.phase() != Some(state) {
            return Ok(None);
        }
        let ahead = (value.rem_euclid(TAU) % TAU - self.place.state[state]).rem_euclid(TAU);
        let here = ahead == 0.0 || (self.time == 0.0 && ahead <= ON);
        let angle = if here { ahead + TAU } else { ahead };
        Ok(Some(angle / self.flow.velocity(&self.place)?.f[state]))
    }

    /// How long the next passage is, and when it ends.
    fn next_stop(&self, gap: Option<f64>) -> (f64, f64) {
        let near = gap.filter(|gap| *gap <= 1.5 * self.chunk);
        let chunk = near.unwrap_or(self.chunk);
        match self.horizon {
            Horizon::Time(end) if end - self.time < chunk && end > self.time => {
                (end - self.time, end)
            }
            _ => (chunk, self.time + chunk),
        }
    }

    /// Judges what a passage has reached, and how long the next one is.
    fn watch(
        &mut self,
        passage: &Passage,
        (time, until): (f64, f64),
        before: usize,
    ) -> Result<(), FlowError> {
        self.time = until;
        let mut reach = Reach::at(&passage.end.state);
        let extrema = passage.extrema.iter().map(|extremum| &extremum.state);
        extrema.for_each(|state| reach.widen(state));
        if let Some(phase) = self.flow.phase() {
            (reach.low[phase], reach.high[phase]) = (0.0, TAU);
        }
        self.reach.join(&reach);
        self.whole.join(&reach);
        let found = self.ready.len() - before;
        if found < ENOUGH && passage.work.steps < STEPS {
            self.chunk = (2.0 * self.chunk).min(self.longest);
        }
        if found == 0 {
            let extents = self.extent().into_iter().zip(&self.usual);
            let sizes: Vec<f64> = extents.map(|(extent, usual)| extent.max(*usual)).collect();
            return self
                .patience
                .take(self.flow, passage, (time, reach), &sizes);
        }
        self.patience = Patience::from(&self.place);
        Ok(())
    }

    /// Where the state is extremal, its rate vanishes.
    fn turn(&mut self, passage: &Passage, until: f64) {
        for extremum in &passage.extrema {
            let absolute = Extremum {
                time: self.time + extremum.time,
                ..extremum.clone()
            };
            let turn = self.turns.take(absolute);
            self.turned(turn);
        }
        if self.horizon == Horizon::Time(until) {
            let last = self.turns.finish(&passage.end.state);
            self.turned(last);
        }
    }

    fn turned(&mut self, turn: Option<Extremum>) {
        if let Some(turn) = turn {
            self.note(Crossing {
                time: turn.time,
                rising: !turn.maximum,
                state: turn.state,
            });
        }
    }

    fn note(&mut self, crossing: Crossing) {
        if self.section.direction.admits(crossing.rising) {
            let state = self.flow.wrapped(crossing.state);
            self.ready.push_back(Crossing { state, ..crossing });
        }
    }
}

impl Iterator for Crossings<'_> {
    type Item = Result<Crossing, FlowError>;

    fn next(&mut self) -> Option<Self::Item> {
        while self.ready.is_empty() && !self.is_over() {
            if let Err(error) = self.follow() {
                self.ended = true;
                return Some(Err(error));
            }
        }
        self.ready.pop_front().map(Ok)
    }
}

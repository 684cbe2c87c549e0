//! The crossings of a section, one after the other.

use std::collections::VecDeque;

use super::radian;
use super::section::{Section, Surface};
use super::turns::Turns;
use crate::field::Work;
use crate::flow::{Flow, FlowError, Passage, Place, Want};

/// Passages without a crossing, each twice as long as the one before, after which no more are awaited.
const SILENCE: u32 = 12;
/// Crossings in a passage that suffice: it need not be longer.
const ENOUGH: usize = 2;
/// A state this close to a level, in units of its rounding, lies on it.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// Share of a period by which a start may be off the section that it lies on.
const INSTANT: f64 = 1e-6;
const ITERATIONS: usize = 80;

/// A point where a motion crosses a section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crossing<const N: usize> {
    /// When, from the beginning of the motion.
    pub time: f64,
    /// Where.
    pub state: [f64; N],
    /// Whether the function that vanishes there grows.
    pub rising: bool,
}

/// The crossings of a motion with a section, in the order of time; an iterator over them.
///
/// It ends when the motion has crossed nothing for a long time, as one that has come to rest. A
/// motion that begins on the section has not crossed it.
pub struct Crossings<'f, F: Flow<N>, const N: usize> {
    flow: &'f F,
    section: Section,
    place: Place<N, F::Mode>,
    time: f64,
    chunk: f64,
    silent: u32,
    ready: VecDeque<Crossing<N>>,
    turns: Turns<N>,
    /// Sign of the state less its level where it was last not zero.
    side: f64,
    low: [f64; N],
    high: [f64; N],
    /// Work of all passages.
    pub work: Work,
}

impl<'f, F: Flow<N>, const N: usize> Crossings<'f, F, N> {
    /// From `place` on.
    ///
    /// # Errors
    /// The field is not finite there.
    pub fn new(flow: &'f F, place: Place<N, F::Mode>, section: Section) -> Result<Self, FlowError> {
        let side = match section.surface {
            Surface::Level { state, value } => side(&place.state, state, value),
            Surface::Rate(_) => 0.0,
        };
        Ok(Self {
            flow,
            section,
            place,
            time: 0.0,
            chunk: radian(flow, &place)?,
            silent: 0,
            ready: VecDeque::new(),
            turns: Turns::of(section.surface.state()),
            side,
            low: place.state,
            high: place.state,
            work: Work::default(),
        })
    }

    /// How far the motion has been followed: at least to the last crossing.
    #[must_use]
    pub fn place(&self) -> (f64, Place<N, F::Mode>) {
        (self.time, self.place)
    }

    /// Smallest and largest value of each state since the beginning, or since the last [`Crossings::forget`].
    #[must_use]
    pub fn range(&self) -> ([f64; N], [f64; N]) {
        (self.low, self.high)
    }

    /// Forgets the range, to measure it anew from here.
    pub fn forget(&mut self) {
        (self.low, self.high) = (self.place.state, self.place.state);
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
        let want = Want {
            extrema: true,
            ..Want::default()
        };
        let passage = self.flow.advance(&self.place, self.chunk, want)?;
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
    fn turn(&mut self, passage: &Passage<N, F::Mode>) {
        for &extremum in &passage.extrema {
            let mut absolute = extremum;
            absolute.time += self.time;
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
    fn cross(
        &mut self,
        passage: &Passage<N, F::Mode>,
        state: usize,
        level: f64,
    ) -> Result<(), FlowError> {
        let start = (0.0, self.place.state);
        let extrema = passage.extrema.iter().filter(|e| e.index == state);
        let turns = extrema.map(|extremum| (extremum.time, extremum.state));
        let stops = turns.chain([(self.chunk, passage.end.state)]);
        let mut from = start;
        for stop in stops {
            let side = side(&stop.1, state, level);
            if side == 0.0 {
                continue;
            }
            if side * self.side < 0.0 {
                let (time, place) = self.meet(state, level, from.0, stop)?;
                self.note(Crossing {
                    time: self.time + time,
                    state: place,
                    rising: side > 0.0,
                });
            }
            self.side = side;
            from = stop;
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
        until: (f64, [f64; N]),
    ) -> Result<(f64, [f64; N]), FlowError> {
        let mut low = (0.0, self.place);
        if from > 0.0 {
            let start = self.place;
            low = (from, self.ahead(&start, from)?);
        }
        let lack = |state: &[f64; N]| state[index] - level;
        let (mut high, mut best) = (until.0, until);
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
            best = (time, place.state);
            if side(&place.state, index, level) == 0.0 {
                break;
            }
            if short * rise < 0.0 {
                low = (time, place);
            } else {
                high = time;
            }
            time -= short / self.flow.velocity(&place)?.f[index];
        }
        Ok(best)
    }

    fn ahead(
        &mut self,
        from: &Place<N, F::Mode>,
        time: f64,
    ) -> Result<Place<N, F::Mode>, FlowError> {
        let passage = self.flow.advance(from, time, Want::default())?;
        self.work += passage.work;
        Ok(passage.end)
    }

    fn note(&mut self, crossing: Crossing<N>) {
        if self.section.direction.admits(crossing.rising) {
            self.ready.push_back(crossing);
        }
    }

    fn widen(&mut self, passage: &Passage<N, F::Mode>) {
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
fn side<const N: usize>(state: &[f64; N], index: usize, level: f64) -> f64 {
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

impl<F: Flow<N>, const N: usize> Iterator for Crossings<'_, F, N> {
    type Item = Result<Crossing<N>, FlowError>;

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

/// The crossings of the motion from `place` up to the time `time`.
///
/// # Errors
/// The motion cannot be followed.
pub fn until<F: Flow<N>, const N: usize>(
    flow: &F,
    place: Place<N, F::Mode>,
    section: Section,
    time: f64,
) -> Result<Vec<Crossing<N>>, FlowError> {
    let mut crossings = Crossings::new(flow, place, section)?;
    let mut found = Vec::new();
    for crossing in &mut crossings {
        match crossing? {
            crossing if crossing.time <= time => found.push(crossing),
            _ => break,
        }
    }
    Ok(found)
}

/// The crossings of the periodic orbit through `place` in one period, each once; their number is the
/// n of a period-n motion.
///
/// # Errors
/// The motion cannot be followed.
pub fn once_around<F: Flow<N>, const N: usize>(
    flow: &F,
    place: Place<N, F::Mode>,
    section: Section,
    period: f64,
) -> Result<Vec<Crossing<N>>, FlowError> {
    let near = INSTANT * period;
    let mut found = until(flow, place, section, period + near)?;
    // A start on the section is met at the end, not at the beginning.
    found.retain(|crossing| crossing.time > near);
    Ok(found)
}

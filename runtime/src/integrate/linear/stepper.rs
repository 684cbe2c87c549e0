//! One step of a linear motion at a time.

use super::bridge::{self, Bridge};
use super::past::Past;
use super::piece::Piece;
use super::{LinearFlow, ONE};
use crate::field::{Point, Work};
use crate::integrate::dense::TERMS;
use crate::integrate::{Carried, Dense, IntegrationError, Tracked};
use crate::scalar::mapped;

/// Part of the tolerance of the dense output of a step of twice the length that the last term of this one may be: what is off
/// then is that term's part of 2⁸ 7.3e-5 ρ/8, the fastest motion that is left going as far as ρ, some 3.
const NEXT: f64 = 100.0;

/// Steps of full length below which what is left of a span is not worth doubled ones.
const WORTH: f64 = 64.0;

/// Makes steps along a linear field: as long as its dense output is true, or shorter.
#[derive(Debug, Clone)]
pub(crate) struct LinearStepper<'f, const N: usize> {
    flow: &'f LinearFlow<N>,
    /// Steps after which to give up.
    budget: u64,
    past: Past<N>,
    time: f64,
    /// The state where the step begins, and the wave of the drive.
    start: Point<N>,
    end: [f64; N],
    length: f64,
    /// How often the next step is doubled, if it may be.
    doublings: usize,
    /// Largest magnitude of each state since the stretch began.
    sizes: [f64; N],
    /// The way of the last attempt.
    dense: Dense<N>,
    /// The same, if it is a doubled step.
    bridge: Option<Box<Bridge<N>>>,
    /// A piece of it, once it is needed.
    piece: Option<Piece<N>>,
    pub(crate) work: Work,
}

impl<'f, const N: usize> LinearStepper<'f, N> {
    /// Begins at `from`.
    pub(crate) fn new(flow: &'f LinearFlow<N>, budget: u64, from: Tracked<N>, time: f64) -> Self {
        let state = *from.state();
        Self {
            flow,
            budget,
            past: Past::new(from),
            time,
            start: flow.at(state),
            end: state,
            length: 0.0,
            doublings: 0,
            sizes: mapped(&state, f64::abs),
            dense: Dense::of_terms(state, 0.0, [[0.0; N]; TERMS]),
            bridge: None,
            piece: None,
            work: Work::default(),
        }
    }

    /// Whether a motion can begin here.
    ///
    /// # Errors
    /// `NotFinite` if the state is not.
    pub(crate) fn check_start(&self) -> Result<(), IntegrationError> {
        if self.past.origin().is_finite() {
            Ok(())
        } else {
            Err(self.not_finite())
        }
    }

    /// The state where the step begins.
    pub(crate) fn from(&self) -> &[f64; N] {
        &self.start.0
    }

    /// The state at the end of the step.
    pub(crate) fn end(&self) -> &[f64; N] {
        &self.end
    }

    pub(crate) fn time(&self) -> f64 {
        self.time
    }

    pub(crate) fn length(&self) -> f64 {
        self.length
    }

    /// Makes a step at most `limit` long, from where the last was committed.
    ///
    /// # Errors
    /// `NotFinite` or `TooManySteps`.
    pub(crate) fn attempt(&mut self, limit: f64) -> Result<(), IntegrationError> {
        if self.work.steps >= self.budget {
            return Err(IntegrationError::TooManySteps {
                steps: self.work.steps,
                time: self.time,
                state: self.start.0.to_vec().into(),
            });
        }
        self.work.evaluations += 1;
        self.piece = None;
        if self.doublings > 0 {
            let worth = limit >= WORTH * self.flow.longest;
            let most = if worth { self.flow.doublings(limit) } else { 0 };
            self.doublings = self.doublings.min(most);
        }
        while self.doublings > 0 && !self.doubled() {
            self.doublings -= 1;
        }
        if self.doublings == 0 {
            self.single(limit.min(self.flow.longest));
        }
        self.arrive(self.dense.length(), self.dense.end())
    }

    /// A step that is not doubled.
    fn single(&mut self, length: f64) {
        self.bridge = None;
        self.dense = match self.flow.whole(length) {
            Some(jump) => jump.path(&self.start),
            None => {
                let piece = self.expand(length);
                let dense = Dense::of_terms(self.start.0, length, piece.series.path());
                self.piece = Some(piece);
                dense
            }
        };
    }

    /// A step that is; whether its dense output is true.
    fn doubled(&mut self) -> bool {
        let eighth = self.flow.leap(self.doublings + ONE - 3);
        let (bridge, dense) = Bridge::new(&self.flow.field, &self.start, eighth);
        let is_true = bridge.is_true(self.flow.error, &self.sizes);
        self.dense = dense;
        match &mut self.bridge {
            Some(last) => **last = bridge,
            none => *none = Some(Box::new(bridge)),
        }
        is_true
    }

    /// Makes the same step with another length, not longer.
    ///
    /// # Errors
    /// `NotFinite` if the end is not.
    pub(crate) fn shorten(&mut self, length: f64) -> Result<(), IntegrationError> {
        let end = self.step_map(length);
        self.arrive(length, end)
    }

    /// The state to which a step of this length would lead, no longer than the last attempt.
    pub(crate) fn step_map(&mut self, length: f64) -> [f64; N] {
        if self.dense.length() == 0.0 {
            return self.start.0;
        }
        let known = self.piece.as_ref();
        if !known.is_some_and(|piece| piece.reaches(length)) {
            self.piece = Some(self.piece(length));
        }
        let piece = self.piece.as_ref();
        piece.map_or(self.end, |piece| piece.state(length))
    }

    /// The piece of the last attempt in which this length ends.
    fn piece(&self, length: f64) -> Piece<N> {
        let Some(bridge) = &self.bridge else {
            return self.expand(self.dense.length());
        };
        let (mut from, state) = bridge.before(length);
        let mut point = self.flow.at(state);
        for number in (ONE..self.doublings + ONE - 3).rev() {
            let leap = self.flow.leap(number);
            if length - from >= leap.length {
                from += leap.length;
                point = self.flow.at(leap.end(&point));
            }
        }
        Piece::new(self.flow, from, &point, self.flow.longest)
    }

    /// f at any state.
    pub(crate) fn slope_at(&self, state: &[f64; N]) -> [f64; N] {
        self.flow.field.f(state)
    }

    /// The polynomial of degree 7 through the step.
    pub(crate) fn dense(&self) -> Dense<N> {
        if self.length == self.dense.length() {
            return self.dense;
        }
        if self.bridge.is_some() {
            return bridge::shortened(&self.dense, self.length);
        }
        let path = self.expand(self.length).series.path();
        Dense::of_terms(self.start.0, self.length, path)
    }

    /// How far the dense output of the last attempt is off, relative to the magnitude of the motion, if it was not doubled.
    pub(crate) fn error(&self) -> f64 {
        match self.bridge {
            Some(_) => 0.0,
            None => self.flow.error(self.dense.length()),
        }
    }

    /// How far it is off in each state, if it was.
    pub(crate) fn errors(&self) -> &[f64; N] {
        match &self.bridge {
            Some(bridge) => &bridge.errors,
            None => &[0.0; N],
        }
    }

    /// The way of the wave along the last attempt, and how far that is off; `None` without a drive.
    pub(crate) fn wave(&self) -> Option<(Dense<3>, [f64; 3])> {
        let field = &self.flow.field;
        let turn = field.rate() * self.dense.length();
        field.is_driven().then(|| bridge::wave(&self.start.1, turn))
    }

    /// The magnitude of the terms of each state along the step.
    pub(crate) fn terms(&self) -> [f64; N] {
        if let Some(bridge) = &self.bridge {
            return bridge.sizes();
        }
        let mut terms = mapped(&self.start.0, f64::abs);
        terms.add(self.length, &self.flow.field.terms(&self.start));
        terms
    }

    /// Takes the end of the step without `drift`, a rounding error of it, as the beginning of the next.
    pub(crate) fn commit_without(&mut self, drift: &[f64; N]) {
        self.work.steps += 1;
        self.time += self.length;
        let whole = self.is_whole().then_some(self.doublings);
        self.past.add(self.length, whole);
        self.end.add(-1.0, drift);
        self.start = self.flow.at(self.end);
        for (size, state) in self.sizes.iter_mut().zip(&self.end) {
            *size = size.max(state.abs());
        }
        self.propose();
    }

    /// Whether the next step is worth doubling once more: not where the last term of this one is more than is tolerated.
    fn propose(&mut self) {
        let mut pairs = self.dense.last().iter().zip(&self.sizes);
        let most = NEXT * self.flow.error;
        if self.is_whole() && pairs.all(|(last, size)| last.abs() <= most * size) {
            self.doublings += 1;
        }
    }

    /// Whether the step has not been shortened, not by a limit either.
    fn is_whole(&self) -> bool {
        self.length == self.dense.length() && self.length >= self.flow.longest
    }

    /// Where the stretch has come to, with its derivatives where they are carried.
    ///
    /// # Errors
    /// `NotFinite` if they are not.
    pub(crate) fn arrived(&self) -> Result<Tracked<N>, IntegrationError> {
        let end = self.past.arrived(self.flow, self.start.0);
        if end.is_finite() {
            Ok(end)
        } else {
            Err(self.not_finite())
        }
    }

    fn expand(&self, length: f64) -> Piece<N> {
        Piece::new(self.flow, 0.0, &self.start, length)
    }

    fn arrive(&mut self, length: f64, end: [f64; N]) -> Result<(), IntegrationError> {
        self.length = length;
        self.end = end;
        if end.is_finite() {
            Ok(())
        } else {
            Err(self.not_finite())
        }
    }

    fn not_finite(&self) -> IntegrationError {
        IntegrationError::NotFinite {
            time: self.time,
            state: self.start.0.to_vec().into(),
        }
    }
}

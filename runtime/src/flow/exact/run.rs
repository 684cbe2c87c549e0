//! One passage of an exact system: smooth stretches, joined at events.

use super::ExactFlow;
use super::extrema::Extrema;
use super::guard::Departure;
use super::steps::Steps;
use super::switch::Strike;
use crate::field::Work;
use crate::field::exact::{ExactField, Modes};
use crate::flow::reach::leaves;
use crate::flow::saltation::product;
use crate::flow::{
    Calm, Derivatives, Determinant, Event, Factor, FlowError, Node, Passage, Place, Sample,
    Segment, Want,
};
use crate::integrate::linear::Blur;
use crate::integrate::{Dense, IntegrationError, Motion, Tracked};
use crate::model::Model;
use crate::scalar::Inline;

/// Part of a passage that is no time: of one a million million times as long as a turn, a small part of that still.
pub(super) const NO_TIME: f64 = 1e-13;
/// Trial steps of the integrator through which derivatives are worth carrying.
const DIFFERENTIATED: u64 = 50_000;
/// Part of the passage that its first step may be.
const FIRST: f64 = 1e-3;
/// Steps on end that may advance the time by no more than [`NO_TIME`] of the passage.
const CREEP: u64 = 20_000;

/// A motion under way.
pub(super) struct Run<'f, M: Model<N>, const N: usize> {
    pub(super) flow: &'f ExactFlow<M, N>,
    pub(super) want: Want,
    pub(super) span: f64,
    pub(super) time: f64,
    pub(super) carried: Tracked<N>,
    pub(super) modes: Modes<M, N>,
    pub(super) departure: M::PerContact<Departure>,
    /// Magnitude of the terms of each relative speed, at the beginning of the stretch.
    pub(super) scales: M::PerContact<f64>,
    pub(super) events: Vec<Event<N>>,
    pub(super) work: Work,
    /// Rate of each |w| at the beginning of the last step, and the length of that step.
    pub(super) rates: (M::PerContact<f64>, f64),
    /// The longest step so far; before the first one what may be one.
    pub(super) longest: f64,
    pub(super) segment_from: f64,
    /// The press whose impact was the last event.
    pub(super) impact: Option<usize>,
    pub(super) segments: Vec<Segment<Modes<M, N>>>,
    pub(super) extrema: Extrema<N>,
    pub(super) path: Vec<Sample<N>>,
    pub(super) nodes: Vec<Node<N>>,
    pub(super) factors: Vec<[[f64; N]; N]>,
    /// What the events made of volumes.
    pub(super) jumps: Determinant,
    /// How far rounding of their guards may have put the state off.
    pub(super) rounding: f64,
    calm: Calm<N, Modes<M, N>>,
    /// Number of events and time when the count of chatter began.
    pub(super) chatter: (u64, f64),
}

impl<'f, M: Model<N>, const N: usize> Run<'f, M, N> {
    pub(super) fn new(
        flow: &'f ExactFlow<M, N>,
        from: &Place<N, Modes<M, N>>,
        span: f64,
        want: Want,
    ) -> Self {
        Self {
            flow,
            want,
            span,
            time: 0.0,
            carried: Tracked::begin(from.state, want.derivatives),
            modes: from.mode,
            departure: Inline::from_fn(|_| Departure::default()),
            scales: flow.speed_scales(&from.state),
            events: Vec::new(),
            work: Work::default(),
            rates: (Inline::from_fn(|_| 0.0), f64::NAN),
            longest: FIRST * span,
            segment_from: 0.0,
            impact: None,
            segments: Vec::new(),
            extrema: Extrema::new(want.extrema, &from.state),
            path: Vec::new(),
            nodes: Vec::new(),
            factors: Vec::new(),
            jumps: Determinant::ONE,
            rounding: 0.0,
            calm: Calm::at(*from),
            chatter: (0, 0.0),
        }
    }

    /// Follows the motion to its end.
    pub(super) fn finish(mut self) -> Result<Passage<N, Modes<M, N>>, FlowError> {
        self.depart()?;
        self.sample(0.0, *self.carried.state());
        while self.goes_on() {
            if let Err(error) = self.segment() {
                return Err(self.outgrown(error));
            }
        }
        self.close_segment();
        let state = *self.carried.state();
        let derivatives = match self.carried.motion().copied() {
            Some(motion) => Some(self.derivatives(&motion)?),
            None => None,
        };
        Ok(Passage {
            end: Place {
                state,
                mode: self.modes,
            },
            time: self.time,
            derivatives,
            extrema: self.extrema.finish(),
            segments: self.segments,
            events: self.events,
            path: self.path,
            nodes: self.nodes,
            calm: self.calm,
            rounding: self.rounding,
            work: self.work,
        })
    }

    fn goes_on(&self) -> bool {
        self.time < self.span && !self.want.suffices(self.path.len())
    }

    fn derivatives(&self, motion: &Motion<N>) -> Result<Derivatives<N>, FlowError> {
        let identity = Motion::from(motion.state).tangent;
        let multiply = |all: [[f64; N]; N], factor| product(factor, &all);
        let factor = |&state: &_| Factor {
            state,
            growth: None,
        };
        let end = self.flow.system.snapshot(&motion.state, &self.modes)?;
        Ok(Derivatives {
            state: self.factors.iter().fold(identity, multiply),
            design: motion.design,
            time: end.field,
            determinant: self.jumps.times(Determinant::grown(motion.trace)),
            factors: self.factors.iter().map(factor).collect(),
            lost: 0,
        })
    }

    /// One smooth stretch, up to an event or to the end.
    fn segment(&mut self) -> Result<(), FlowError> {
        let flow = self.flow;
        let field = ExactField::new(&flow.system, self.modes, self.carried.state())?;
        self.scales = flow.speed_scales(self.carried.state());
        let mut settings = flow.settings;
        let blur = match self.want.looks_for_extrema() || M::INFO.moving {
            true => Blur::Fine,
            false => Blur::Coarse,
        };
        let sharp = (settings.tolerance, blur);
        let linear = flow.stretches.as_ref();
        let linear = linear.and_then(|stretches| stretches.along(&field, sharp));
        let known = linear.as_deref();
        if known.is_none() && self.carried.motion().is_some() {
            settings.steps = settings.steps.min(DIFFERENTIATED);
        }
        let spent = self.work.steps + self.work.rejected;
        settings.steps = settings.steps.saturating_sub(spent);
        let rest = (self.time, self.span - self.time);
        let mut stepper = Steps::begin(&field, known, settings, self.carried, rest);
        stepper.check_start()?;
        let mut strike = None;
        let mut since = (0_u64, self.time);
        while strike.is_none() && self.goes_on() {
            strike = self.step(&mut stepper, &field)?;
            since.0 += 1;
            if self.time - since.1 > NO_TIME * self.span {
                since = (0, self.time);
            } else if since.0 > CREEP {
                return Err(FlowError::Integration(IntegrationError::StepTooSmall {
                    time: self.time,
                    step: stepper.length(),
                    state: self.carried.state().to_vec().into(),
                }));
            }
        }
        self.work += stepper.work();
        self.carried = stepper.arrived()?;
        match strike {
            Some(strike) => self.switch(&strike),
            None => Ok(()),
        }
    }

    /// One step, so short that its dense output leaves no doubt whether a guard falls, and shortened to the first event in it.
    fn step(
        &mut self,
        stepper: &mut Steps<'_, 'f, M, N>,
        field: &ExactField<'f, M, N>,
    ) -> Result<Option<Strike<M, N>>, FlowError> {
        let speeds = self.flow.system.speeds(stepper.from());
        let rest = self.span - self.time;
        let mut limit = self.approach(stepper, &speeds).min(rest);
        let mut nearest = Vec::new();
        // Not a function of its own: what it would hand back is large.
        let (mut dense, fall) = loop {
            self.reach(stepper, limit)?;
            let dense = stepper.dense();
            match self.watch(stepper, &speeds, &dense, &mut nearest)? {
                Some(fall) => break (dense, fall),
                None => limit = 0.5 * stepper.length(),
            }
        };
        let mut strike = None;
        let whole = stepper.length();
        let left = leaves::<M, N>(self.flow.system.values(), &|theta| dense.state(theta));
        if let Some(fall) = fall {
            let length = self.locate(stepper, &fall);
            stepper.shorten(length)?;
            strike = self.struck(stepper, &fall)?;
            if self.want.looks_for_extrema() || self.want.path {
                dense = stepper.dense();
            }
        }
        if let Some((theta, found)) = left
            && theta * whole <= stepper.length()
        {
            let state = stepper.step_map(theta * whole);
            return Err(FlowError::beyond(&found, self.time + theta * whole, &state));
        }
        self.note_nearest(stepper, whole, &nearest)?;
        self.observe(stepper, &dense);
        if stepper.linear().is_some() {
            self.offer_middle(stepper.length(), &dense);
        }
        self.arrive(stepper, field, strike.is_some());
        Ok(strike)
    }

    fn offer_middle(&mut self, length: f64, dense: &Dense<N>) {
        let (half, mode) = (0.5 * length, self.modes);
        self.calm.offer_middle(self.time + half, half, || Place {
            state: dense.state(half / dense.length()),
            mode,
        });
    }

    /// Goes on to the end of the step, which is `struck` by an event or not.
    fn arrive(
        &mut self,
        stepper: &mut Steps<'_, 'f, M, N>,
        field: &ExactField<'f, M, N>,
        struck: bool,
    ) {
        let length = stepper.length();
        let time = self.time + length;
        // A rest that the time cannot resolve is none, and an event just before it is at the end.
        let last = self.span - time <= f64::EPSILON * self.span;
        self.time = if last { self.span } else { time };
        self.departure = Inline::from_fn(|_| Departure::default());
        self.rates.1 = if struck { f64::NAN } else { length };
        self.longest = self.longest.max(length);
        stepper.commit_without(&field.drift(stepper.end()));
        *self.carried.state_mut() = *stepper.from();
        if !struck {
            let place = Place {
                state: *stepper.from(),
                mode: self.modes,
            };
            self.calm.offer(self.time, length, place);
        }
    }
}

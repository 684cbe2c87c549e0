//! The exact flow: friction is set-valued, switching instants are located, derivatives jump through them.

mod alternation;
mod approach;
mod bearing;
mod bounce;
mod box_qp;
mod chatter;
mod collide;
mod depart;
mod departure;
mod extrema;
mod forms;
mod glide;
mod guard;
mod idle;
mod look;
mod observe;
mod passing;
mod press;
mod reaction;
mod reading;
mod release;
mod run;
mod settle;
mod steps;
mod stretch;
mod switch;
mod watch;

use crate::field::Strip;
use crate::field::exact::{ExactSystem, Mode, Modes, linear_of};
use crate::flow::countable;
use crate::flow::reach::beyond;
use crate::flow::{Flow, FlowError, Passage, Place, Velocity, Want};
use crate::integrate::Tolerance;
use crate::integrate::explicit::Settings;
use crate::model::{Model, ModelInfo, ParamId};
use crate::scalar::{Inline, Lanes};
use press::Vanishing;
use run::Run;
pub use settle::Arrival;
use settle::Rest;
use stretch::Stretches;
pub(crate) use stretch::in_closed_form;

/// Rounding error of a relative speed in units of its terms, below which it is none.
const NO_SPEED: f64 = 4.0 * f64::EPSILON;

/// The motion of a model with its declared friction laws as they are.
///
/// A place at which a contact sticks is put on the surface w = 0 of that contact before the motion
/// begins, and derivatives count that as part of the motion: its start then follows the surface.
pub struct ExactFlow<M: Model<N>, const N: usize> {
    system: ExactSystem<M, N>,
    settings: Settings,
    arrival: Arrival,
    /// What is known in closed form, where the model is linear between events.
    stretches: Option<Stretches<M, N>>,
}

/// An exact motion knows no stops.
fn without_stops(info: &ModelInfo) -> Result<(), FlowError> {
    let stopping = info.memories.iter().find(|memory| memory.law.has_stops());
    match stopping {
        Some(memory) => Err(FlowError::NoExactStops {
            law: memory.law.name,
        }),
        None => Ok(()),
    }
}

impl<M: Model<N>, const N: usize> ExactFlow<M, N> {
    /// The flow of `model`, with `design` as design variable, to this tolerance.
    ///
    /// # Errors
    /// A parameter outside its bounds, or a friction force that does not oppose its speed.
    pub fn new(
        model: &M,
        design: Option<ParamId<M>>,
        tolerance: Tolerance,
    ) -> Result<Self, FlowError> {
        M::INFO.check(model.values().as_ref())?;
        without_stops(M::INFO)?;
        let system = ExactSystem::new(model, design.map(|parameter| parameter.index));
        system.check()?;
        let settings = Settings {
            steps: 1_000_000,
            stiff_steps: 1000,
            persists: true,
            ..Settings::new(tolerance)
        };
        Ok(Self {
            system,
            settings,
            arrival: Arrival::default(),
            stretches: Stretches::of_model(),
        })
    }

    /// The same flow by the integrator alone, also where the model is proven to be linear between events and closed forms
    /// are taken for it: slower, with the integrator's errors, and so an independent check.
    #[must_use]
    pub fn integrated(mut self) -> Self {
        self.stretches = None;
        self
    }

    /// The equations that it follows.
    pub(crate) fn system(&self) -> &ExactSystem<M, N> {
        &self.system
    }

    /// The same flow, its states measured against these magnitudes where they pass through zero.
    #[must_use]
    pub fn with_magnitude(mut self, magnitude: [f64; N]) -> Self {
        self.system = self.system.with_magnitude(magnitude);
        self.stretches = self.stretches.and_then(|_| Stretches::of_model());
        self
    }

    /// The same with another rule for contacts that may both stick and cross.
    #[must_use]
    pub fn with_arrival(mut self, arrival: Arrival) -> Self {
        self.arrival = arrival;
        self
    }

    /// Whether all laws hold at a state.
    ///
    /// # Errors
    /// A field of a law is out of its bounds there.
    pub(crate) fn within_laws(&self, state: [f64; N]) -> Result<(), FlowError> {
        let found = beyond::<M, N>(self.system.values(), state);
        found.map_or(Ok(()), |found| Err(FlowError::beyond(&found, 0.0, &state)))
    }

    /// A contact without relative speed sticks if it can, the others slide.
    fn settle_at(&self, state: [f64; N]) -> Result<Place<N, Modes<M, N>>, FlowError> {
        let speeds = self.system.speeds(&state);
        let scales = self.speed_scales(&state);
        let speed = |i: usize| speeds.as_ref()[i];
        let slides = Modes::from_fn(|i| match M::INFO.contacts.get(i) {
            Some(_) => Mode::sliding(speed(i)),
            None => Mode::Open,
        });
        let rounded = |_| Some(Vanishing::Rounded);
        let presses = self.with_presses(&state, slides, &rounded)?;
        let rest = |slides: Modes<M, N>| {
            let resting: M::PerContact<bool> = Inline::from_fn(|i| {
                slides.as_slice()[i].rubs()
                    && !self.system.is_idle(i)
                    && speed(i).abs() <= NO_SPEED * scales.as_ref()[i]
            });
            Rest {
                system: &self.system,
                arrival: self.arrival,
                state,
                time: 0.0,
                before: Modes::from_fn(|i| {
                    if resting.as_ref()[i] {
                        Mode::Stick
                    } else {
                        slides.as_slice()[i]
                    }
                }),
                resting,
                let_go: Inline::from_fn(|_| 0.0),
            }
        };
        let verdict = self.borne(&state, 0.0, &presses, &rest)?;
        Ok(Place {
            state,
            mode: verdict.modes,
        })
    }

    /// The relative speed of each contact, and what of it is rounding error.
    pub(crate) fn speeds(&self, state: &[f64; N]) -> (M::PerContact<f64>, M::PerContact<f64>) {
        let scales = self.speed_scales(state);
        let rounding = Inline::from_fn(|i| NO_SPEED * scales.as_ref()[i]);
        (self.system.speeds(state), rounding)
    }

    /// The magnitude of the terms of each relative speed: what its rounding error is measured against.
    fn speed_scales(&self, state: &[f64; N]) -> M::PerContact<f64> {
        let speeds = self.system.speeds(state);
        let scale = |i: usize, gradient: &Strip<N>| gradient.terms(speeds.as_ref()[i], state);
        let bent = Self::presses().any(|press| !self.system.is_straight(press));
        if let (Some(gradients), false) = (self.system.gradients(), bent) {
            return Inline::from_fn(|i| scale(i, &gradients[i]));
        }
        let lanes = self.system.linear_speeds(state);
        Inline::from_fn(|i| {
            let (gradient, _): ([f64; N], f64) = lanes.as_ref()[i].slopes();
            scale(i, &gradient.into())
        })
    }
}

impl<M: Model<N>, const N: usize> Flow<N> for ExactFlow<M, N> {
    type Mode = Modes<M, N>;
    const PHASE: Option<usize> = M::INFO.drive;

    fn place(&self, state: [f64; N]) -> Result<Place<N, Self::Mode>, FlowError> {
        self.settle_at(state)
    }

    fn sticking(mode: &Self::Mode) -> usize {
        mode.as_slice().iter().map(|mode| mode.lost()).sum()
    }

    fn advance(
        &self,
        from: &Place<N, Self::Mode>,
        time: f64,
        want: Want,
    ) -> Result<Passage<N, Self::Mode>, FlowError> {
        if !(time.is_finite() && time >= 0.0) {
            return Err(FlowError::BadTime { time });
        }
        self.within_laws(from.state)?;
        if let (Some(phase), true) = (M::INFO.drive, want.notes_turns()) {
            let rates = self.system.snapshot(&from.state, &from.mode)?.field;
            countable(rates[phase], time)?;
        }
        Run::new(self, from, time, want).finish()
    }

    fn velocity(&self, at: &Place<N, Self::Mode>) -> Result<Velocity<N>, FlowError> {
        let linear = linear_of(&self.system.linear(&at.state, &at.mode)?.field);
        Ok(Velocity {
            f: linear.f,
            jacobian: linear.jacobian,
            design: linear.design,
            lost: 0,
        })
    }
}

#[cfg(test)]
mod tests;

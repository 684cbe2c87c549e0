//! The flow of a smooth field: explicit until the motion turns stiff, implicit from there.
//!
//! Where internal states of laws have stops, it is smooth between the instants at which they meet or leave one.

mod inside;
mod laws;
mod record;
mod rest;
mod unfelt;

pub(super) use rest::check_stops;

use std::ops::ControlFlow;

use super::{Factor, Flow, FlowError, Passage, Place, Velocity, Want, countable};
use crate::field::{Field, SmoothField, Work};
use crate::integrate::explicit::{Settings, integrate};
use crate::integrate::{IntegrationError, RADAU_5, Radau, Tolerance};
use crate::model::Model;
use record::Record;

/// Trial steps after which a passage is given up.
const BUDGET: u64 = 200_000;
/// Trial steps through which derivatives are worth carrying.
const DIFFERENTIATED: u64 = 50_000;
/// A step that has jumped a layer is tried again over this share of its length.
const SHORTER: f64 = 0.3;
/// Explicit trial steps after which the rest is left to the implicit method: where errors are tolerated that hide its
/// stiffness, an explicit method creeps without an end.
const EXPLICIT_BUDGET: u64 = 20_000;
/// A layer this many times faster than the rest of the motion is stiff from the start.
const STIFF_LAYER: f64 = 30.0;

/// The motion of a model whose friction is smoothed, or that has none.
#[derive(Clone, Copy)]
pub struct SmoothFlow<M: Model<N>, const N: usize> {
    field: SmoothField<M, N>,
    tolerance: Tolerance,
    stiff: bool,
}

impl<M: Model<N>, const N: usize> SmoothFlow<M, N> {
    /// The flow of `field`, integrated to this local tolerance.
    ///
    /// A field whose friction layers are much faster than the rest of its motion is integrated
    /// implicitly throughout; any other explicitly, until Hairer's test finds it stiff.
    #[must_use]
    pub fn new(field: SmoothField<M, N>, tolerance: Tolerance) -> Self {
        let (layer, rest) = field.rates();
        Self {
            field,
            tolerance,
            stiff: layer > STIFF_LAYER * rest,
        }
    }

    /// The field that moves it.
    #[must_use]
    pub fn field(&self) -> &SmoothField<M, N> {
        &self.field
    }

    /// Whether some state decays so fast that an explicit method could not follow it for this time.
    fn damps(&self, state: &[f64; N], time: f64) -> bool {
        let jacobian = self.field.linearise(state).jacobian;
        let fastest = (0..N).map(|i| -jacobian[i][i]).fold(0.0, f64::max);
        fastest * time > EXPLICIT_BUDGET as f64
    }

    fn explicit(&self, record: &mut Record<N>, time: f64) -> Result<(), FlowError> {
        while record.time < time && !record.suffices() {
            let outcome = self.explicit_stretch(&record.field(&self.field), record, time);
            match outcome {
                Ok(()) => {}
                Err(FlowError::Integration(
                    IntegrationError::Stiff { .. } | IntegrationError::TooManySteps { .. },
                )) => break,
                Err(error) => return Err(error),
            }
        }
        if record.want.factors {
            record.factors.push(Factor {
                state: record.motion.tangent,
                growth: None,
            });
        }
        Ok(())
    }

    /// Follows the motion until a stop is met or left, or to the end.
    fn explicit_stretch(
        &self,
        field: &SmoothField<M, N>,
        record: &mut Record<N>,
        time: f64,
    ) -> Result<(), FlowError> {
        let spent = record.work.steps + record.work.rejected;
        let settings = Settings {
            steps: EXPLICIT_BUDGET.saturating_sub(spent),
            ..Settings::new(self.tolerance.explicit())
        };
        let mut work = Work::default();
        let mut verdict = Ok(());
        let (from, span) = (record.motion, time - record.time);
        record.since = record.time;
        let mut switched = false;
        let outcome = if record.want.derivatives {
            integrate(field, settings, from, span, &mut work, |step| {
                let felt = self.feel(step);
                record.motion = *step.end();
                record.explicit_step(field, step);
                let span = (record.since + step.time(), step.length());
                let kept = M::INFO.moving.then(|| step.dense());
                let kept = kept.map_or(felt, |dense| self.keep_laws(span, &|t| dense.state(t)));
                switched = record.switch(field, step.fallen());
                self.watch(record, switched, (kept, &mut verdict))
            })
            .map(|motion| motion.state)
        } else {
            integrate(field, settings, from.state, span, &mut work, |step| {
                let felt = self.feel(step);
                record.motion.state = *step.end();
                record.explicit_step(field, step);
                let span = (record.since + step.time(), step.length());
                let kept = M::INFO.moving.then(|| step.dense());
                let kept = kept.map_or(felt, |dense| self.keep_laws(span, &|t| dense.state(t)));
                switched = record.switch(field, step.fallen());
                self.watch(record, switched, (kept, &mut verdict))
            })
        };
        record.work += work;
        verdict?;
        outcome?;
        if !(switched || record.suffices()) {
            record.time = time;
        }
        Ok(())
    }

    fn watch(
        &self,
        record: &Record<N>,
        switched: bool,
        (kept, verdict): (Result<(), FlowError>, &mut Result<(), FlowError>),
    ) -> ControlFlow<()> {
        *verdict = kept.and_then(|()| self.check_direction(record));
        if verdict.is_err() || switched || record.suffices() {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    fn implicit(&self, record: &mut Record<N>, time: f64) -> Result<(), FlowError> {
        if SmoothField::<M, N>::STOPS && record.want.factors && record.factors.is_empty() {
            record.factors.push(Factor {
                state: record.motion.tangent,
                growth: None,
            });
        }
        while record.time < time && !record.suffices() {
            self.implicit_stretch(&record.field(&self.field), record, time)?;
        }
        Ok(())
    }

    /// Follows the motion until a stop is met or left, or to the end.
    fn implicit_stretch(
        &self,
        field: &SmoothField<M, N>,
        record: &mut Record<N>,
        time: f64,
    ) -> Result<(), FlowError> {
        let (offset, rest) = (record.time, time - record.time);
        let start = record.motion.state;
        let budget = if record.want.derivatives {
            DIFFERENTIATED
        } else {
            BUDGET
        };
        let budget = budget.saturating_sub(record.implicit);
        let mut radau = Radau::new(field, &RADAU_5, self.tolerance, start, 0.0, budget)?;
        let mut outcome = Ok(());
        let mut switched = false;
        // When the integrator set out.
        let mut since = 0.0;
        while outcome.is_ok() && !switched && !record.suffices() && radau.time() < rest - since {
            outcome = match radau.step(rest - since) {
                Ok(step) if self.jumps(&step) => {
                    since += step.time;
                    record.work += radau.work;
                    record.work.steps -= 1;
                    record.work.rejected += 1;
                    let left = budget.saturating_sub(record.work.steps + record.work.rejected);
                    let shorter = SHORTER * step.step;
                    Radau::new(field, &RADAU_5, self.tolerance, step.start, shorter, left)
                        .map(|again| radau = again)
                        .map_err(FlowError::from)
                }
                Ok(step) => {
                    record.implicit_step(&mut radau, &step, offset + since);
                    switched = record.switch(field, radau.fallen());
                    let span = (offset + since + step.time, step.step);
                    let kept = self.keep_laws(span, &|theta| step.inside(theta));
                    kept.and_then(|()| self.check_direction(record))
                }
                Err(error) => Err(error.into()),
            };
        }
        record.work += radau.work;
        record.implicit += radau.work.steps + radau.work.rejected;
        if !(switched || record.suffices()) {
            record.time = time;
        }
        outcome
    }

    fn check_direction(&self, record: &Record<N>) -> Result<(), FlowError> {
        match self.field.backwards(&record.motion.state) {
            Some((contact, speed)) => Err(FlowError::Backwards {
                contact: M::INFO.contact_id(contact),
                time: record.time,
                speed,
            }),
            None => Ok(()),
        }
    }
}

impl<M: Model<N>, const N: usize> Flow<N> for SmoothFlow<M, N> {
    type Mode = ();
    const PHASE: Option<usize> = M::INFO.drive;

    fn place(&self, state: [f64; N]) -> Result<Place<N, ()>, FlowError> {
        check_stops(&self.field)?;
        let mut state = state;
        if SmoothField::<M, N>::STOPS {
            self.field.settled(&mut state);
        }
        Ok(Place { state, mode: () })
    }

    fn advance(
        &self,
        from: &Place<N, ()>,
        time: f64,
        want: Want,
    ) -> Result<Passage<N, ()>, FlowError> {
        if !(time >= 0.0 && time.is_finite()) {
            return Err(FlowError::BadTime { time });
        }
        check_stops(&self.field)?;
        self.within_laws(from.state)?;
        if let (Some(phase), true) = (M::INFO.drive, want.notes_turns()) {
            countable(self.field.f(&from.state)[phase], time)?;
        }
        let mut record = Record::new(from.state, want, M::INFO.drive);
        record.settle(&self.field);
        if time > 0.0 && !self.stiff && !self.damps(&from.state, time) {
            self.explicit(&mut record, time)?;
        }
        if record.time < time && !record.suffices() {
            self.implicit(&mut record, time)?;
        }
        let velocity = record.field(&self.field).f(&record.motion.state);
        record.passage(velocity)
    }

    fn velocity(&self, at: &Place<N, ()>) -> Result<Velocity<N>, FlowError> {
        let field = rest::settled(&self.field, at.state);
        let linear = field.linearise(&at.state);
        if !linear.f.iter().all(|component| component.is_finite()) {
            return Err(IntegrationError::NotFinite {
                time: 0.0,
                state: at.state.to_vec().into(),
            }
            .into());
        }
        Ok(Velocity {
            f: linear.f,
            jacobian: linear.jacobian,
            design: linear.design,
            lost: field.stops().resting(),
        })
    }
}

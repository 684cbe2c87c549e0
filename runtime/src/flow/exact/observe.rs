//! What is noted along the way: near misses, extrema, samples of the path, stretches of constant mode.

use super::guard::Sighting;
use super::run::Run;
use super::steps::Steps;
use crate::field::exact::{Mode, Modes};
use crate::flow::{Event, EventKind, FlowError, Sample, Segment, nodes};
use crate::integrate::Dense;
use crate::model::Model;

/// Part of the passage within which a gap that is nearest to closing is nearest at an event.
const INSTANT: f64 = 1e-10;
/// Samples of the path for each step.
const SAMPLES: u32 = 8;

impl<'f, M: Model<N>, const N: usize> Run<'f, M, N> {
    /// Records how near each guard came to falling before the end of the step.
    pub(super) fn note_nearest(
        &mut self,
        stepper: &mut Steps<'_, 'f, M, N>,
        whole: f64,
        nearest: &[Sighting],
    ) -> Result<(), FlowError> {
        for sighting in nearest {
            let length = sighting.theta * whole;
            if length < stepper.length() {
                let state = stepper.step_map(length);
                let at = self.flow.system.snapshot(&state, &self.modes)?;
                let margin = sighting.guard.value(&self.modes, &at);
                let contact = sighting.guard.contact;
                self.events.push(Event {
                    kind: EventKind::Nearest { margin },
                    contact,
                    mode: self.modes.as_slice()[contact],
                    time: self.time + length,
                    state,
                    rate: 0.0,
                });
            }
        }
        Ok(())
    }

    /// Records the gaps that come nearest to closing just where contacts switch, as that of a wall beside a mass whose friction
    /// turns with it: neither the step that ends there nor the next one has its minimum inside. `before` are the modes up to
    /// there.
    pub(super) fn note_nearest_here(&mut self, before: &Modes<M, N>) -> Result<(), FlowError> {
        if !self.want.looks_for_extrema() || M::INFO.presses.is_empty() {
            return Ok(());
        }
        let (system, state) = (&self.flow.system, *self.carried.state());
        let at = system.moving(&state, &self.modes)?;
        let bends = system.second_rates(&state, &self.modes, &at.field);
        let instant = INSTANT * self.span;
        for contact in M::INFO.contacts.len()..system.contacts() {
            let modes = [before, &self.modes].map(|modes| modes.as_slice()[contact]);
            let (gap, bend) = (at.speed.as_ref()[contact], bends.as_ref()[contact]);
            let near = gap.re > 0.0 && bend > 0.0 && gap.eps.abs() <= instant * bend;
            let mut late = self.events.iter().rev();
            let mut late = late
                .by_ref()
                .take_while(|one| self.time - one.time <= instant);
            if modes == [Mode::Open; 2] && near && !late.any(|one| one.contact == contact) {
                self.events.push(Event {
                    kind: EventKind::Nearest { margin: gap.re },
                    contact,
                    mode: Mode::Open,
                    time: self.time,
                    state,
                    rate: 0.0,
                });
            }
        }
        Ok(())
    }

    /// Looks for extrema in the step just made, and samples it.
    pub(super) fn observe(&mut self, stepper: &mut Steps<'_, 'f, M, N>, dense: &Dense<N>) {
        if self.want.looks_for_extrema() {
            self.extrema.look(stepper, dense);
        }
        if self.want.notes_turns() {
            self.extrema.strobe(M::INFO.drive, stepper);
        }
        let (from, length) = (self.time, stepper.length());
        nodes(self.want, (from, length), &mut self.nodes, |theta| {
            stepper.step_map(theta * length)
        });
        if self.want.path {
            for k in 1..=SAMPLES {
                let theta = f64::from(k) / f64::from(SAMPLES);
                self.sample(from + theta * length, stepper.between(theta, dense));
            }
        }
    }

    /// Adds a sample to the path, if that is wanted.
    pub(super) fn sample(&mut self, time: f64, state: [f64; N]) {
        if self.want.path {
            self.path.push(Sample { time, state });
        }
    }

    /// Ends a stretch of constant mode; one without duration is left out, its factor goes to the next.
    pub(super) fn close_segment(&mut self) {
        let duration = self.time - self.segment_from;
        if duration <= 0.0 && (self.time < self.span || !self.segments.is_empty()) {
            return;
        }
        self.segments.push(Segment {
            mode: self.modes,
            duration,
            impact: self.impact.take(),
        });
        self.segment_from = self.time;
        if let Some(motion) = self.carried.motion() {
            self.factors.push(motion.tangent);
            motion.restart();
        }
    }
}

//! Impacts on a motion under way: the state jumps, and its derivatives with it.

use super::press::Vanishing;
use super::run::Run;
use super::settle::Rest;
use super::switch::{ROUNDING, Strike};
use crate::field::exact::{ContactError, Mode, Modes};
use crate::flow::saltation::{Reset, Saltation, Tracked};
use crate::flow::{Event, EventKind, FlowError, SensitivityUndefined};
use crate::model::Model;
use crate::scalar::{Inline, Lanes};

impl<M: Model<N>, V: Tracked<N>, const N: usize> Run<'_, M, V, N> {
    /// The press that is hit at this instant, if one that does not give way is.
    ///
    /// # Errors
    /// Several are, and act on each other.
    pub(super) fn hit(&self, strike: &Strike<M, N>) -> Result<Option<usize>, FlowError> {
        let closes = |i: &usize| M::INFO.is_rigid(*i) && strike.fallen.as_ref()[*i].is_some();
        let hit: Vec<usize> = (0..strike.fallen.as_ref().len()).filter(closes).collect();
        let state = self.carried.state();
        let acts = |a: usize, b: usize| a != b && self.flow.system.acts_on(state, a, b);
        if hit.iter().any(|&a| hit.iter().any(|&b| acts(a, b))) {
            return Err(FlowError::HitTogether {
                contacts: hit,
                time: self.time,
            });
        }
        Ok(hit.first().copied())
    }

    /// Passes an impact; whatever else falls at this instant falls again after it.
    pub(super) fn bounce(&mut self, press: usize, strike: &Strike<M, N>) -> Result<(), FlowError> {
        let (system, time) = (&self.flow.system, self.time);
        let (before, state) = (self.modes, *self.carried.state());
        let impact = system.impact(&state, press);
        if impact.compliance.is_nan() || impact.compliance <= 0.0 {
            return Err(ContactError::NotOpposing {
                contact: press,
                compliance: impact.compliance,
            }
            .into());
        }
        let verdict = self.rebounding(press, &impact.state)?;
        let field = system.snapshot(&state, &before)?.field;
        let after = system.snapshot(&impact.state, &verdict.modes)?.field;
        if let Some(motion) = self.carried.motion() {
            let (gradient, design) = system.linear_speeds(&state).as_ref()[press].slopes();
            let slopes: [([f64; N], f64); N] = {
                let linear = system.linear_impact(&state, press).state;
                std::array::from_fn(|i| linear[i].slopes())
            };
            let reset = Reset {
                slopes: slopes.map(|(state, _)| state),
                design: slopes.map(|(_, design)| design),
            };
            let saltation = Saltation {
                before: field,
                after,
                gradient,
                design,
            };
            saltation
                .reset(motion, &reset, strike.grazes)
                .map_err(|rate| SensitivityUndefined::Grazing {
                    contact: press,
                    time,
                    rate,
                })?;
        }
        self.close_segment();
        self.extrema.jump(time, &state, &impact.state);
        *self.carried.state_mut() = impact.state;
        self.sample(time, impact.state);
        self.impact = Some(press);
        self.work.events += 1;
        self.events.push(Event {
            kind: EventKind::Impact {
                approach: impact.approach,
                departure: impact.departure,
            },
            contact: press,
            mode: Mode::Open,
            time,
            state: impact.state,
            rate: -impact.approach,
        });
        self.take(&verdict, &Inline::from_fn(|_| 0.0))?;
        self.count_chatter(press)
    }

    /// The modes after an impact: other contacts as their speeds are then, which it may have changed.
    fn rebounding(
        &self,
        press: usize,
        state: &[f64; N],
    ) -> Result<super::settle::Verdict<M, N>, FlowError> {
        let flow = self.flow;
        let known = |i: usize| {
            Some(if i == press {
                Vanishing::Gap
            } else {
                Vanishing::Rounded
            })
        };
        let presses = flow.with_presses(state, self.modes, known)?;
        let (speeds, scales) = (flow.system.speeds(state), flow.speed_scales(state));
        let speed = |i: usize| speeds.as_ref()[i];
        let modes = presses.modes.as_slice();
        let resting = Inline::from_fn(|i| {
            let still = speed(i).abs() <= ROUNDING * scales.as_ref()[i];
            modes[i].rubs() && !flow.system.is_idle(i) && still
        });
        let before = Modes::from_fn(|i| match modes[i] {
            mode if !mode.rubs() => mode,
            _ if M::PerContact::<bool>::as_ref(&resting)[i] => Mode::Stick,
            _ => Mode::sliding(speed(i)),
        });
        let mut verdict = Rest {
            system: &flow.system,
            arrival: flow.arrival,
            state: *state,
            time: self.time,
            before,
            resting,
            let_go: Inline::from_fn(|_| 0.0),
        }
        .settle()?;
        presses.note(&mut verdict);
        Ok(verdict)
    }
}

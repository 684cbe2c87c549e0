//! How one period of an exact orbit responds to what a copy does differently, to first order.

use std::ops::ControlFlow;

use super::PredictError;
use super::history::{History, Switch, TIGHT};
use super::rubbing::Rubbed;
use super::virtual_field::VirtualField;
use crate::field::Work;
use crate::field::exact::{Mode, Modes};
use crate::flow::saltation::Saltation;
use crate::integrate::Motion;
use crate::integrate::explicit::{Settings, integrate};
use crate::model::Model;
use crate::motion::exact::place;
use crate::motion::fixed;
use crate::scalar::{Inline, Lanes};

/// Halvings by which the end of a stretch of sticking is approached, where creep grows fastest.
const HALVINGS: i32 = 24;

/// Φ and the copy's deviation p at one time of the period.
#[derive(Debug)]
pub(crate) struct Response {
    pub(super) time: f64,
    pub(super) state: Vec<f64>,
    pub(super) tangent: Vec<Vec<f64>>,
    pub(super) deviation: Vec<f64>,
    /// f there.
    pub(super) velocity: Vec<f64>,
}

/// A walk through the period.
struct Walk<'a, M: Model<N>, const N: usize> {
    rubbed: &'a Rubbed<M, N>,
    history: &'a History,
    time: f64,
    modes: Modes<M, N>,
    motion: Motion<N>,
}

/// The response at `times` (in order, the last is the period) to the losses in `history`.
pub(super) fn response<M: Model<N>, const N: usize>(
    rubbed: &Rubbed<M, N>,
    history: &History,
    times: &[f64],
) -> Result<Vec<Response>, PredictError> {
    let start = place(&history.start);
    let mut walk = Walk {
        rubbed,
        history,
        time: 0.0,
        modes: start.mode,
        motion: Motion::from(start.state),
    };
    walk.settle([0.0; N])?;
    let mut readings = Vec::new();
    let mut next = 0;
    for instant in history.instants(times) {
        walk.advance(instant)?;
        if times.contains(&instant) {
            readings.push(walk.reading()?);
        }
        while let Some(switch) = history.switches.get(next)
            && switch.event.time <= instant
        {
            walk.pass(switch)?;
            next += 1;
        }
    }
    Ok(readings)
}

impl<'a, M: Model<N>, const N: usize> Walk<'a, M, N> {
    fn field(&self) -> Result<VirtualField<'a, M, N>, PredictError> {
        // Asked for in the middle of a stretch, so that no end of one decides by rounding.
        let history = self.history;
        let inside = self.time + 1e-9 * history.period;
        let cap = |i: usize| history.cap(i, inside);
        Ok(VirtualField::new(
            &self.rubbed.system,
            history.smoothing,
            self.modes,
            &self.motion.state,
            |i| if history.leading { 0.0 } else { cap(i) },
            |i| !history.leading && history.has_tail(i, inside),
        )?)
    }

    fn advance(&mut self, until: f64) -> Result<(), PredictError> {
        let field = self.field()?;
        let span = until - self.time;
        let pieces = if self.modes.sticking().next().is_some() {
            HALVINGS
        } else {
            0
        };
        let mut work = Work::default();
        let mut left = span;
        for piece in 0..=pieces {
            let length = if piece == pieces { left } else { 0.5 * left };
            left -= length;
            let settings = Settings::new(TIGHT);
            self.motion = integrate(&field, settings, self.motion, length, &mut work, |_| {
                ControlFlow::Continue(())
            })?;
        }
        self.time = until;
        Ok(())
    }

    /// p = q + L c.
    fn deviation(&self) -> Result<[f64; N], PredictError> {
        let field = self.field()?;
        let state = &self.motion.state;
        let lifted = field.lift(state, &field.creep(state));
        Ok(std::array::from_fn(|j| self.motion.design[j] + lifted[j]))
    }

    fn reading(&self) -> Result<Response, PredictError> {
        let state = &self.motion.state;
        let velocity = self.rubbed.system.snapshot(state, &self.modes)?.field;
        Ok(Response {
            time: self.time,
            state: state.to_vec(),
            tangent: self.motion.tangent.map(|row| row.to_vec()).to_vec(),
            deviation: self.deviation()?.to_vec(),
            velocity: velocity.to_vec(),
        })
    }

    /// Goes on from the deviation p: takes out of it, and of Φ, what contacts that stick determine.
    fn settle(&mut self, deviation: [f64; N]) -> Result<(), PredictError> {
        let field = self.field()?;
        let state = self.motion.state;
        let off = field.lift(&state, &field.rates(&state, &deviation));
        self.motion.design = std::array::from_fn(|j| deviation[j] - off[j]);
        for column in 0..N {
            let along = std::array::from_fn(|row| self.motion.tangent[row][column]);
            let off = field.lift(&state, &field.rates(&state, &along));
            for (row, change) in self.motion.tangent.iter_mut().zip(off) {
                row[column] -= change;
            }
        }
        Ok(())
    }

    /// Passes a switch: its saltation, and what a release loses.
    fn pass(&mut self, switch: &Switch) -> Result<(), PredictError> {
        let (i, state) = (switch.event.contact, fixed(&switch.event.state));
        self.motion.state = state;
        let mut deviation = self.deviation()?;
        if let Some(loss) = &switch.loss {
            let field = self.field()?;
            let mut shift: M::PerContact<f64> = Inline::from_fn(|_| 0.0);
            let way = switch.after.modes[i].sign();
            shift.as_mut()[i] = way * loss.offset - field.rates(&state, &deviation).as_ref()[i];
            let jump = field.lift(&state, &shift);
            deviation = std::array::from_fn(|j| deviation[j] + jump[j]);
        }
        self.motion.design = deviation;
        let saltation = self.saltation(switch)?;
        saltation
            .apply(&mut self.motion, false)
            .map_err(|rate| PredictError::Grazing {
                contact: M::INFO.contact_id(i),
                time: switch.event.time,
                rate,
            })?;
        let late = self.late(switch, &saltation);
        self.modes = place(&switch.after).mode;
        let deviation = std::array::from_fn(|j| self.motion.design[j] + late[j]);
        self.settle(deviation)
    }

    /// What a copy lags behind that takes longer to cross: it moves on with the later field where the exact one had begun to.
    /// With q = −b ∫ (F_copy − F) dt, ∇w b ∫ (F_copy − F) dt = u̇⁺ Δt and f⁺ − f⁻ = −2 slip b, that is (f⁺ − f⁻) u̇⁺ Δt / (u̇⁻ − u̇⁺).
    fn late(&self, switch: &Switch, saltation: &Saltation<N>) -> [f64; N] {
        let share = switch.crossing.zip(switch.passing);
        let share = share.map_or(0.0, |(crossing, passing)| {
            let [before, after] = crossing.rates;
            after * passing.delay / (before - after)
        });
        std::array::from_fn(|j| share * (saltation.after[j] - saltation.before[j]))
    }

    fn saltation(&self, switch: &Switch) -> Result<Saltation<N>, PredictError> {
        let (i, system) = (switch.event.contact, &self.rubbed.system);
        let [before, after] = [&switch.before, &switch.after].map(place);
        let linear = system.linear(&before.state, &before.mode)?;
        let (gradient, design) = if switch.before.modes[i] == Mode::Stick {
            let side = -switch.after.modes[i].sign();
            let guard = linear.stick.as_ref()[i] - linear.force.as_ref()[i] * side;
            // A delay of the release raises the limit by what the force grows meanwhile.
            let raised = switch
                .release
                .zip(switch.loss)
                .map_or(0.0, |(release, loss)| release.load_rate * loss.delay);
            (guard.slopes().0, raised)
        } else {
            (linear.speed.as_ref()[i].slopes().0, 0.0)
        };
        Ok(Saltation {
            before: system.snapshot(&before.state, &before.mode)?.field,
            after: system.snapshot(&after.state, &after.mode)?.field,
            gradient,
            design,
            magnitude: system.magnitude,
        })
    }
}

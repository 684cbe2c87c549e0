//! What a passage at a border adds, to first order.
//!
//! A damper acts as soon as a gap closes, however slowly: while a press is closed that was only to be grazed, its force c v
//! takes out a speed that is as large as the depth to which the gap would have fallen, and of that order; then the press
//! lets go. What the spring adds is of a higher order. The other way round, a gap that opens for a moment, while its press
//! would begin to push again, is spared as much.

use nalgebra::{DMatrix, DVector};

use super::arrival::{Arrival, along, carried};
use super::candidate::{Border, Condition};
use crate::field::exact::Mode;
use crate::flow::FlowError;
use crate::motion::Flow;

/// Share of the period before the border at which the direction of the contact's force is read.
const BEFORE: f64 = 1e-6;

/// The passage at the border itself.
pub(super) struct Passing<'a> {
    pub(super) border: &'a Border,
    pub(super) flow: &'a dyn Flow,
    pub(super) state: &'a [f64],
    pub(super) period: f64,
    /// Slopes of the guard of the mode in which the contact comes, and of the second number that vanishes.
    pub(super) guard: (DVector<f64>, f64),
    pub(super) limit: (DVector<f64>, f64),
}

impl Passing<'_> {
    /// Ξ, and what r adds: where the event does not happen, or where it does.
    pub(super) fn leap(&self, happens: bool) -> Result<Arrival, FlowError> {
        let order = self.state.len();
        let nothing = Arrival {
            state: DMatrix::identity(order, order),
            design: DVector::zeros(order),
        };
        match self.border.condition {
            Condition::Edge => {
                let (before, held) = self.fields(self.state)?;
                let landed = along(&self.guard, &nothing, &(&held - &before), &before);
                if self.border.after() == Mode::Stick {
                    return Ok(landed);
                }
                // Where friction drops, a brief stick has a release of its own.
                let after = self.flow.velocity(&self.border.going(self.state))?.f;
                Ok(if happens {
                    along(&self.limit, &landed, &(&after - &held), &held)
                } else {
                    along(&self.guard, &nothing, &(after - &before), &before)
                })
            }
            Condition::Touch if happens && self.border.is_graze() => {
                let coming = self.border.coming(self.state);
                let velocity = self.flow.velocity(&coming)?.f;
                let earlier: Vec<f64> = self
                    .state
                    .iter()
                    .zip(velocity.iter())
                    .map(|(x, f)| x - BEFORE * self.period * f)
                    .collect();
                let (before, held) = self.fields(&earlier)?;
                let push = held - before;
                Ok(along(&self.guard, &nothing, &-&push, &push))
            }
            Condition::Touch => {
                let pressed = if happens {
                    self.pressed(nothing)?
                } else {
                    nothing
                };
                if !self.border.turns() {
                    return Ok(pressed);
                }
                let (before, jump) = self.turn()?;
                Ok(along(&self.limit, &pressed, &jump, &before))
            }
        }
    }

    /// What a press that gives way adds while it is closed for a moment, or spares while it is open, if it is one: J ġ being by
    /// how much the field jumps where the gap closes at the rate ġ, y + J g.
    fn pressed(&self, from: Arrival) -> Result<Arrival, FlowError> {
        let border = self.border;
        let open = border.coming(self.state);
        let closes = matches!(border.before(), Mode::Open | Mode::Parted);
        if !closes || self.flow.kick(&open, border.contact)?.is_some() {
            return Ok(from);
        }
        let mut closed = open.clone();
        closed.modes[border.contact] = Mode::Closed;
        closed.modes = (self.flow).loosened(closed.modes, &self.flow.speeds(self.state));
        let [open, closed] = [self.flow.velocity(&open)?, self.flow.velocity(&closed)?];
        let bend = self.limit.0.dot(&open.f);
        // The rate grows by this in a unit of time, the jump by what both fields change by.
        let push = (closed.jacobian - open.jacobian) * &open.f / bend;
        Ok(carried(&self.guard, &from, &push))
    }

    /// The field in which the motion comes, and by what it jumps where contacts turn.
    fn turn(&self) -> Result<(DVector<f64>, DVector<f64>), FlowError> {
        let before = self.flow.velocity(&self.border.coming(self.state))?.f;
        let after = self.flow.velocity(&self.border.going(self.state))?.f;
        let jump = after - &before;
        Ok((before, jump))
    }

    /// What a unit speed of approach adds to the state at the border, and how fast the rate of the gap grows there.
    pub(super) fn kick(&self) -> Result<Option<(DVector<f64>, f64)>, FlowError> {
        let (border, flow) = (self.border, self.flow);
        if border.condition != Condition::Touch || border.before() != Mode::Open {
            return Ok(None);
        }
        let coming = border.coming(self.state);
        let Some(kick) = flow.kick(&coming, border.contact)? else {
            return Ok(None);
        };
        let bend = self.limit.0.dot(&flow.velocity(&coming)?.f);
        let mut kick = DVector::from_vec(kick);
        if border.turns() {
            // What is hit turns earlier, by v/g̈.
            kick += self.turn()?.1 / bend;
        }
        Ok((bend > 0.0).then_some((kick, bend)))
    }

    /// The field in which the motion comes, and the one with the contact held.
    fn fields(&self, state: &[f64]) -> Result<(DVector<f64>, DVector<f64>), FlowError> {
        let coming = self.flow.velocity(&self.border.coming(state))?.f;
        Ok((coming, self.flow.velocity(&self.border.stuck(state))?.f))
    }

    /// The arrival where the guard has fallen.
    pub(super) fn on_surface(&self, arrival: &Arrival) -> Result<Arrival, FlowError> {
        let (before, _) = self.fields(self.state)?;
        Ok(along(&self.guard, arrival, &-&before, &before))
    }
}

//! Impacts that alternate between presses ever faster, as those of a block that rocks to rest: how they come to their end.

use super::bounce::Rebound;
use super::chatter::LOWEST;
use super::press::Vanishing;
use super::run::Run;
use crate::field::exact::{Impulses, Mode};
use crate::flow::FlowError;
use crate::model::Model;

impl<M: Model<N>, const N: usize> Run<'_, M, N> {
    /// What an impact becomes that makes others leave where they rested, for a flight too low to be told from none: all that
    /// follow are as good as one after which all of them rest. Their impulses take the speeds that are left; reactions make
    /// up for it until the flights would have ended.
    ///
    /// `None` if none is made to leave, one flies higher, friction under it would have a say, or they would not rest.
    pub(super) fn at_rest_together(
        &self,
        rebound: &Rebound<M, N>,
    ) -> Result<Option<Rebound<M, N>>, FlowError> {
        let impulses = &rebound.collision.0;
        let modes = rebound.verdict.modes.as_slice();
        let leaves = |q: &usize| *q != impulses.press && modes[*q] == Mode::Open;
        let left: Vec<usize> = self.modes.resting().filter(leaves).collect();
        if left.is_empty() {
            return Ok(None);
        }
        let mut together = Impulses {
            press: impulses.press,
            modes: impulses.modes,
            lasts: true,
        };
        let mut lasts = 0.0_f64;
        for press in left {
            let Some(flight) = self.low_flight(press, rebound)? else {
                return Ok(None);
            };
            lasts = lasts.max(flight);
            together.modes.set(press, Mode::Rest);
        }
        let Ok(impact) = self.flow.system.impact(self.carried.state(), &together) else {
            return Ok(None);
        };
        let collision = (together, impact);
        let Ok(verdict) = self.rebounding(&collision, Vanishing::Both) else {
            return Ok(None);
        };
        let rests = |press: usize| verdict.modes.as_slice()[press] == Mode::Rest;
        let resting = collision.0.modes.resting().all(rests);
        Ok(resting.then_some(Rebound {
            collision,
            verdict,
            settles: Some(lasts),
        }))
    }

    /// How long a press flies that an impact made leave, if that is as low as rounding leaves of a gap, and nothing rubs
    /// under it.
    fn low_flight(&self, press: usize, rebound: &Rebound<M, N>) -> Result<Option<f64>, FlowError> {
        let (system, state) = (&self.flow.system, &rebound.collision.1.state);
        if M::INFO.rubs_under(press).any(|i| !system.is_idle(i)) {
            return Ok(None);
        }
        let departure = -system.approach(state, press).0;
        let pull = -self.bend(press, state, rebound.verdict.modes)?;
        let low = self
            .flight(press, state, departure)
            .stays_below(LOWEST, pull);
        Ok(low.then_some(2.0 * departure / pull))
    }
}

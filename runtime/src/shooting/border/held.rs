//! How much of the motion around a border is held in its modes, as events come nearer along a curve.

use super::candidate::Border;
use crate::field::Work;
use crate::flow::{FlowError, Want};
use crate::motion::{Flow, Place};

/// Part of what is held, next to the border, in which its own contact may switch for rounding, and in which it may off the border.
const OWN: f64 = 0.05;
const FAR: f64 = 0.5;
/// Share of the period next to the border that is held at least.
const LEAST: f64 = 1e-5;

impl Border {
    /// Lets go half of the way to events that have come to lie in what is held: it would be held on where it switches.
    ///
    /// # Errors
    /// The motion between both ends cannot be followed.
    pub(super) fn hold_less(
        &mut self,
        flow: &dyn Flow,
        state: &[f64],
        period: f64,
    ) -> Result<Work, FlowError> {
        let ([first, last], turn) = (self.held, self.turn());
        let start = self.going(state);
        let mut work = Work::default();
        let mut switches = |from: &Place, share: f64| {
            let passage = flow.advance(from, share * period, Want::default());
            let Ok(passage) = passage else {
                return Vec::new();
            };
            work += passage.work;
            let switches = passage.events.into_iter();
            let switches = switches.filter(|event| event.kind.is_switch());
            switches
                .map(|event| (event.contact, event.time / period))
                .collect()
        };
        // Off the border its own contact may switch next to it: then only what is further away tells.
        for begins in [OWN, FAR].map(|share| share * first) {
            let from = flow.glide(&start, begins * period)?.0;
            let found: Vec<(usize, f64)> = switches(&from, first - begins);
            let own = |(contact, after): &(usize, f64)| {
                *contact == self.contact && begins + after < FAR * first
            };
            if found.iter().any(own) {
                continue;
            }
            if let Some((_, after)) = found.first() {
                self.held[0] = (0.5 * (begins + after)).max(LEAST);
            }
            break;
        }
        let lead = flow.glide(&start, self.held[0] * period)?.0;
        let middle = (last - self.held[0]) * period;
        let round = flow.advance(&lead, middle, Want::default())?;
        let found = switches(&round.end, (1.0 - OWN) * (turn - last));
        let tells = |(contact, after): &&(usize, f64)| {
            *contact != self.contact || *after < FAR * (turn - last)
        };
        if let Some((_, after)) = found.iter().rev().find(tells) {
            self.held[1] = (0.5 * (last + after + turn)).min(turn - LEAST);
        }
        work += round.work;
        Ok(work)
    }
}

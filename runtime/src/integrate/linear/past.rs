//! How a stretch depends on where it began: asked for once, at its end, and not at each of its steps.

use super::LinearFlow;
use super::piece::Piece;
use crate::field::Point;
use crate::integrate::{Motion, Propagator, Tracked};

/// Where a stretch began, with its derivatives, and how far it has come from there.
#[derive(Debug, Clone)]
pub(super) struct Past<const N: usize> {
    origin: Tracked<N>,
    /// So many steps of full length, and the rest.
    steps: u64,
    rest: f64,
}

/// The way of a stretch: where its last part begins, which is no full step, and how its end depends on its beginning.
struct Passed<const N: usize> {
    before: Point<N>,
    rest: f64,
    propagator: Propagator<N>,
}

impl<const N: usize> Past<N> {
    pub(super) fn new(origin: Tracked<N>) -> Self {
        Self {
            origin,
            steps: 0,
            rest: 0.0,
        }
    }

    pub(super) fn origin(&self) -> &Tracked<N> {
        &self.origin
    }

    /// A step more: of this length, or of full length and doubled so often.
    pub(super) fn add(&mut self, length: f64, doublings: Option<usize>) {
        match doublings {
            Some(doublings) => self.steps += 1 << doublings,
            None => self.rest += length,
        }
    }

    /// What has come to this state.
    pub(super) fn arrived(&self, flow: &LinearFlow<N>, state: [f64; N]) -> Tracked<N> {
        self.origin.led_to(state, || self.passed(flow).propagator)
    }

    fn passed(&self, flow: &LinearFlow<N>) -> Passed<N> {
        let mut point = flow.at(*self.origin.state());
        let mut total = None;
        let mut pass = |step: Propagator<N>| {
            total = Some(match &total {
                Some(before) => step.after(before),
                None => step,
            });
        };
        let (mut steps, mut rest) = (self.steps, self.rest);
        if rest >= flow.longest {
            let whole = (rest / flow.longest).floor();
            (steps, rest) = (steps + whole as u64, rest - whole * flow.longest);
        }
        for number in LinearFlow::<N>::numbers(steps) {
            let leap = flow.leap(number);
            pass(leap.propagator(&flow.field, &point));
            point = flow.at(leap.end(&point));
        }
        if rest > 0.0 {
            pass(flow.powers(rest).propagator(&flow.field, &point, rest));
        }
        Passed {
            before: point,
            rest,
            propagator: total.unwrap_or(Propagator::IDENTITY),
        }
    }
}

impl<const N: usize> LinearFlow<N> {
    /// A motion this time later.
    pub(crate) fn after(&self, motion: Motion<N>, time: f64) -> Motion<N> {
        let mut past = Past::new(Tracked::Motion(motion));
        past.add(time, None);
        let Passed {
            before,
            rest,
            propagator,
        } = past.passed(self);
        let state = match rest > 0.0 {
            true => Piece::new(self, 0.0, &before, rest).state(rest),
            false => before.0,
        };
        Motion {
            state,
            ..motion.through(&propagator)
        }
    }
}

//! An orbit that slides by rounding alone lies on the border of those that friction holds. Few of its digits are known, while
//! those beside it are told as sharply as any: one of them is as good.

use nalgebra::DVector;

use super::grip::keeps_mode;
use super::guess::Guess;
use super::neutral::{Null, SUSPECT};
use super::newton::Found;
use super::problem::OrbitProblem;
use crate::continuation::ZeroProblem;
use crate::flow::{FlowError, Want};
use crate::motion::Passage;

/// How far beside it an orbit is looked for, in usual magnitudes of the states.
const ASIDE: [f64; 3] = [1e-3, 1e-2, 1e-4];

impl OrbitProblem {
    /// The guess of an orbit beside this one that friction holds all along where this one slides for moments, if there is one.
    ///
    /// # Errors
    /// There is no flow at r.
    pub(super) fn inside(
        &self,
        r: f64,
        found: &Found,
        guess: &Guess,
    ) -> Result<Option<Guess>, FlowError> {
        let shot = &found.linearisation.extra;
        let slides: Vec<usize> = shot.give_way().collect();
        if self.modes.len() > 1 || slides.is_empty() {
            return Ok(None);
        }
        let flow = self.family.at(r)?;
        let held = |lap: &Passage| slides.iter().all(|contact| keeps_mode(lap, *contact));
        let near = Null::within(&found.linearisation, &self.scale(), SUSPECT);
        let directions = near.map_or_else(Vec::new, |null| null.right);
        let ways = ASIDE.iter().flat_map(|aside| {
            let sides = directions
                .iter()
                .flat_map(|way| [way * *aside, way * -aside]);
            sides.collect::<Vec<_>>()
        });
        let at = |way: DVector<f64>| {
            let mut state = shot.start.state.clone();
            for ((y, by), unit) in state.iter_mut().zip(way.iter()).zip(&self.magnitude) {
                *y += by * unit;
            }
            let place = flow.place(&state).ok()?;
            let lap = flow.advance(&place, shot.period, Want::default()).ok()?;
            held(&lap).then(|| Guess {
                place,
                period: shot.period,
                pins: Vec::new(),
                ..guess.clone()
            })
        };
        Ok(ways.into_iter().find_map(at))
    }
}

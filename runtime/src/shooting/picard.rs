//! Steps of Newton's method with turns of the motion between them.

use super::anchor::anchored;
use super::converge::from;
use super::guess::Guess;
use super::newton::one_step;
use super::orbit::Orbit;
use super::sought::Search;
use crate::flow::Want;
use crate::motion::Family;

/// Steps, each with a turn after it.
const STEPS: usize = 4;

/// The orbit of a driven motion that is found from a guess by Newton's method where a turn after each step brings back what decays within it;
/// `None` where that leads to none.
///
/// A long step changes when contacts switch, and with that what fast motions are like at its end, which no derivative tells:
/// the residual rises in them, and a turn on they have died away. Where orbits are not alone, the motion may come to another.
pub(super) fn eased(family: &Family, r: f64, guess: &Guess, search: &Search) -> Option<Orbit> {
    family.at(r).ok()?.phase()?;
    let mut guess = guess.clone();
    for _ in 0..STEPS {
        let moved = one_step(family, r, &guess, search.segments, search.accuracy)?;
        let flow = family.at(r).ok()?;
        let turn = flow.advance(&moved.place, moved.period, Want::default());
        let mut place = turn.ok()?.end;
        place.state = flow.wrapped(place.state);
        guess = Guess { place, ..moved };
    }
    let orbit = from(family, r, &guess, search, anchored).ok()?;
    orbit.pins.is_empty().then_some(orbit)
}

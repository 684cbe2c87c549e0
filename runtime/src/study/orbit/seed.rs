//! Where orbits are looked for.

use crate::field::exact::Mode;
use crate::model::ModelInfo;
use crate::motion::{Contact, Flow, Modes, Place, Row};
use crate::study::equilibria::sliding_mode;

/// Sweeps over all contacts that bring their speeds to zero together.
const SWEEPS: usize = 50;

/// A place to begin, with a guess of the period; without one, the motion settles from there.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::study) struct Seed {
    pub(in crate::study) start: Vec<f64>,
    pub(in crate::study) period: Option<f64>,
    /// Whether the motion is meant on which it settles.
    pub(in crate::study) settles: bool,
}

impl Seed {
    pub(in crate::study) fn at(start: Vec<f64>) -> Self {
        Self {
            start,
            period: None,
            settles: false,
        }
    }
}

/// From rest on the belt: near `start`, each contact in turn without relative speed, then all; then the same places
/// where those contacts need no force to stay at rest, from which they surely stick.
pub(in crate::study) fn on_the_belt(flow: &dyn Flow, info: &ModelInfo, start: &[f64]) -> Vec<Seed> {
    let count = info.contacts.len();
    let mut sets: Vec<Vec<usize>> = (0..count).map(|contact| vec![contact]).collect();
    if count > 1 {
        sets.push((0..count).collect());
    }
    let belt = Belt { flow, info };
    let near = sets.iter().map(|set| belt.resting(start.to_vec(), set));
    let unloaded = sets.iter().map(|set| belt.unloaded(start.to_vec(), set));
    near.chain(unloaded).map(Seed::at).collect()
}

/// A flow and its contacts.
struct Belt<'a> {
    flow: &'a dyn Flow,
    info: &'a ModelInfo,
}

impl Belt<'_> {
    /// The state next to `state` at which these contacts have no relative speed, by projection on one after the other.
    fn resting(&self, state: Vec<f64>, contacts: &[usize]) -> Vec<f64> {
        // While all slide, no force is sought, and none enters the speeds.
        settled(state, |mut state| {
            let modes = sliding_mode(self.flow, self.info, &state);
            for &contact in contacts {
                if let Some(Contact { speed, .. }) = self.contact(&state, &modes, contact) {
                    project(&mut state, &speed);
                }
            }
            state
        })
    }

    /// The same where, besides, they need no force to stay at rest.
    fn unloaded(&self, state: Vec<f64>, contacts: &[usize]) -> Vec<f64> {
        let mut modes = sliding_mode(self.flow, self.info, &state);
        for &contact in contacts {
            modes[contact] = Mode::Stick;
        }
        settled(state, |mut state| {
            for &contact in contacts {
                if let Some(Contact { force, .. }) = self.contact(&state, &modes, contact) {
                    project(&mut state, &force);
                }
            }
            self.resting(state, contacts)
        })
    }

    /// What a contact does; `None` if the forces are not determined.
    fn contact(&self, state: &[f64], modes: &Modes, contact: usize) -> Option<Contact> {
        let place = Place {
            state: state.to_vec(),
            modes: modes.clone(),
        };
        let mut all = self.flow.contacts(&place).ok()?.all;
        (contact < all.len()).then(|| all.swap_remove(contact))
    }
}

/// What sweeps over all contacts make of a state, until one changes nothing any more.
fn settled(mut state: Vec<f64>, mut sweep: impl FnMut(Vec<f64>) -> Vec<f64>) -> Vec<f64> {
    for _ in 0..SWEEPS {
        let swept = sweep(state.clone());
        if swept == state {
            break;
        }
        state = swept;
    }
    state
}

/// Moves a state the shortest way to where a quantity that is linear in it vanishes.
fn project(state: &mut [f64], quantity: &Row) {
    let square: f64 = quantity.slopes.iter().map(|slope| slope * slope).sum();
    let share = quantity.value / square;
    if share.is_finite() {
        for (component, slope) in state.iter_mut().zip(&quantity.slopes) {
            *component -= share * slope;
        }
    }
}

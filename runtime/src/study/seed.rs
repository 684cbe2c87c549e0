//! Where orbits are looked for.

use crate::field::exact::{ExactSystem, Mode, Modes};
use crate::model::Model;
use crate::scalar::Lanes;

/// Sweeps over all contacts that bring their speeds to zero together.
const SWEEPS: usize = 50;

/// A place to begin, with a guess of the period; without one, the motion settles from there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Seed<const N: usize> {
    pub(super) start: [f64; N],
    pub(super) period: Option<f64>,
}

impl<const N: usize> Seed<N> {
    pub(super) fn at(start: [f64; N]) -> Self {
        Self {
            start,
            period: None,
        }
    }
}

/// From rest on the belt: near `start`, each contact in turn without relative speed, then all; then the same places
/// where those contacts need no force to stay at rest, from which they surely stick.
pub(super) fn on_the_belt<M: Model<N>, const N: usize>(model: &M, start: [f64; N]) -> Vec<Seed<N>> {
    let system = ExactSystem::new(model, None);
    let count = system.contacts();
    let mut sets: Vec<Vec<usize>> = (0..count).map(|contact| vec![contact]).collect();
    if count > 1 {
        sets.push((0..count).collect());
    }
    let near = sets.iter().map(|set| resting(&system, start, set));
    let unloaded = sets.iter().map(|set| unloaded(&system, start, set));
    near.chain(unloaded).map(Seed::at).collect()
}

/// The state next to `state` at which these contacts have no relative speed, by projection on one after the other.
fn resting<M: Model<N>, const N: usize>(
    system: &ExactSystem<M, N>,
    mut state: [f64; N],
    contacts: &[usize],
) -> [f64; N] {
    for _ in 0..SWEEPS {
        for &contact in contacts {
            let speed = system.linear_speeds(&state).as_ref()[contact];
            project(&mut state, speed);
        }
    }
    state
}

/// The same where, besides, they need no force to stay at rest.
fn unloaded<M: Model<N>, const N: usize>(
    system: &ExactSystem<M, N>,
    mut state: [f64; N],
    contacts: &[usize],
) -> [f64; N] {
    let modes = Modes::from_fn(|i| {
        if contacts.contains(&i) {
            Mode::Stick
        } else {
            Mode::sliding(system.speeds(&state).as_ref()[i])
        }
    });
    for _ in 0..SWEEPS {
        for &contact in contacts {
            if let Ok(held) = system.linear(&state, &modes) {
                project(&mut state, held.force.as_ref()[contact]);
            }
        }
        state = resting(system, state, contacts);
    }
    state
}

/// Moves a state the shortest way to where a quantity that is linear in it vanishes.
fn project<D: Lanes<N>, const N: usize>(state: &mut [f64; N], quantity: D) {
    let (gradient, _) = quantity.slopes();
    let square: f64 = gradient.iter().map(|slope| slope * slope).sum();
    let share = quantity.re() / square;
    if share.is_finite() {
        for (component, slope) in state.iter_mut().zip(gradient) {
            *component -= share * slope;
        }
    }
}

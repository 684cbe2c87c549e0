//! Where orbits are looked for.

use crate::field::exact::ExactSystem;
use crate::model::Model;
use crate::scalar::Lanes;
use num_dual::DualStruct;

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

/// From rest on the belt: near `start`, each contact in turn without relative speed, then all.
pub(super) fn on_the_belt<M: Model<N>, const N: usize>(model: &M, start: [f64; N]) -> Vec<Seed<N>> {
    let system = ExactSystem::new(model, None);
    let count = system.contacts();
    let each = (0..count).map(|contact| resting(&system, start, &[contact]));
    let all: Vec<usize> = (0..count).collect();
    let together = (count > 1).then(|| resting(&system, start, &all));
    each.chain(together).map(Seed::at).collect()
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
            let (gradient, _) = speed.slopes();
            let square: f64 = gradient.iter().map(|slope| slope * slope).sum();
            let share = speed.re() / square;
            if share.is_finite() {
                for (component, slope) in state.iter_mut().zip(gradient) {
                    *component -= share * slope;
                }
            }
        }
    }
    state
}

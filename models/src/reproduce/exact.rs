//! The system with its declared friction, beside its smooth copies.

use std::time::{Duration, Instant};

use stickslip::continuation::Settings;
use stickslip::field::Work;
use stickslip::field::exact::Modes;
use stickslip::flow::{ExactFamily, Family, Flow, Want};
use stickslip::integrate::Tolerance;
use stickslip::model::{Model, ParamId};
use stickslip::shooting::{Orbit, OrbitBranch, closest};

use super::follow::{ACCURACY, FollowError, search};

/// Longer steps would do for the branch, but not for a smooth drawing of it.
const LARGEST_STEP: f64 = 0.05;

/// A periodic orbit with friction that sticks, and its branch.
pub(super) struct Exact<M: Model<N>, const N: usize> {
    /// One period of its motion.
    pub(super) path: Vec<[f64; N]>,
    /// All orbits of the branch, in the order of r.
    pub(super) orbits: Vec<Orbit<N, Modes<M, N>>>,
    pub(super) time: Duration,
    pub(super) work: Work,
}

/// The orbit at r = `from` that is reached from `start`, and its branch to each of `ends`, or as far as it goes.
pub(super) fn follow<M: Model<N>, const N: usize>(
    model: M,
    along: ParamId<M>,
    (from, start): (f64, [f64; N]),
    ends: &[f64],
) -> Result<Exact<M, N>, FollowError> {
    let family = ExactFamily {
        model,
        design: Some(along.index),
        tolerance: Tolerance::for_accuracy(ACCURACY),
        magnitude: [1.0; N],
    };
    let orbit = closest(&family, from, &search(start, None))?;
    let clock = Instant::now();
    let want = Want {
        path: true,
        ..Want::default()
    };
    let passage = family.at(from)?.advance(&orbit.place, orbit.period, want)?;
    let mut orbits = Vec::new();
    for &to in ends {
        let settings = Settings {
            largest_step: LARGEST_STEP,
            ..Settings::new(from, to, ACCURACY)
        };
        let near = search(orbit.place.state, Some(orbit.period));
        let branch =
            OrbitBranch::start(&family, &orbit, &near, settings).map_err(FollowError::Start)?;
        // The second branch begins where the first one did.
        orbits.extend(branch.skip(usize::from(!orbits.is_empty())));
    }
    orbits.sort_by(|a, b| a.r.total_cmp(&b.r));
    let mut work = Work::default();
    orbits.iter().for_each(|orbit| work += orbit.work);
    Ok(Exact {
        path: passage.path.iter().map(|sample| sample.state).collect(),
        orbits,
        time: clock.elapsed(),
        work,
    })
}

impl<M: Model<N>, const N: usize> Exact<M, N> {
    /// A quantity of the orbits along the branch.
    pub(super) fn along(&self, of: fn(&Orbit<N, Modes<M, N>>) -> f64) -> Vec<[f64; 2]> {
        self.orbits.iter().map(|o| [o.r, of(o)]).collect()
    }
}

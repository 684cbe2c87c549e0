//! States without meaning: what is the same at two of them is taken to be the same everywhere.

use crate::model::Model;
use crate::scalar::filled;

/// Seeds of two generic states.
pub(crate) const GENERIC: [f64; 2] = [0.317, 0.871];

/// The generic state of a seed.
pub(crate) fn generic_state<M: Model<N>, const N: usize>(seed: f64) -> [f64; N] {
    let numbers = generic::<N>(seed);
    filled(|i| {
        let start = M::INFO.states.get(i).map_or(0.0, |state| state.start);
        start + (1.0 + start.abs()) * numbers[i]
    })
}

/// Numbers without meaning in (0, 1), others for each seed: a direction in which no two states move alike.
pub(crate) fn generic<const N: usize>(seed: f64) -> [f64; N] {
    filled(|i| 0.1 + 0.8 * (seed + 0.618_033_988_749_895 * (i + 1) as f64).fract())
}

//! How the tests ask, and how they compare.

use stickslip::model::Model;
use stickslip::study::{Case, EquilibriaRecord, Kind, OrbitRecord, System};

use crate::reference::{Motion, Plant, follow};

/// A model with its parameters as a system and a case.
pub fn case<M: Model<N>, const N: usize>(model: &M) -> (System, Case) {
    (System::of::<M, N>(), Case::of(model))
}

/// The orbit of a model, and whether a hand-written plant comes back to its start after its period.
#[track_caller]
pub fn returns<const N: usize, const C: usize>(
    orbit: &OrbitRecord,
    plant: &impl Plant<N, C>,
    tolerance: f64,
) -> Motion<N> {
    let start: [f64; N] = std::array::from_fn(|j| orbit.state[j]);
    let motion = follow(plant, start, (0.0, orbit.period), 1e-12);
    for (j, place) in start.iter().enumerate() {
        let near =
            |found, expected, what| close(found, expected, tolerance * orbit.max_abs[j], what);
        near(motion.state[j], *place, "where it comes back");
        near(motion.max[j], orbit.max[j], "largest value");
        near(motion.min[j], orbit.min[j], "smallest value");
    }
    motion
}

/// The first special point of this kind: its parameter, and 2π over its period.
#[track_caller]
pub fn special(record: &EquilibriaRecord, kind: Kind) -> (f64, f64) {
    let mut points = record.special.iter();
    let found = points.find(|point| point.kind == kind);
    let point = found.unwrap_or_else(|| panic!("{:?}, {}", record.special, record.ended.reason));
    let frequency = point
        .period
        .map_or(0.0, |period| std::f64::consts::TAU / period);
    (point.r, frequency)
}

#[track_caller]
pub fn close(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!(
        (found - expected).abs() <= tolerance,
        "{what}: {found} instead of {expected}"
    );
}

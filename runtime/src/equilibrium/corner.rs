//! The slopes on both sides of a corner on which an equilibrium lies.
//!
//! What rests on a law with internal state that holds something, as on bristles that are bent, is where |w| has its corner:
//! the slopes of the law differ there with the sign of w, and rounding would choose between them.

use nalgebra::DMatrix;

use crate::math::Spread;
use crate::motion::{Flow, Place};

/// How far to both sides, in magnitudes of the states: more than they are off, and so little that nothing else shows.
const ASIDE: f64 = 1e-9;

/// The slopes of the rates on both sides of a place, if there are laws that have corners.
pub(super) fn sides(flow: &dyn Flow, place: &Place, magnitude: &[f64]) -> Vec<DMatrix<f64>> {
    if flow.corners() == 0 {
        return Vec::new();
    }
    let spread = Spread::new(magnitude.len());
    let aside = |sign: f64| {
        let shares = spread.point(0).zip(magnitude);
        let shift = shares.map(|(share, size)| sign * ASIDE * (1.0 + share) * size);
        let state = place.state.iter().zip(shift).map(|(y, shift)| y + shift);
        let place = Place {
            state: state.collect(),
            modes: place.modes.clone(),
        };
        Some(flow.velocity(&place).ok()?.jacobian)
    };
    [1.0, -1.0].into_iter().filter_map(aside).collect()
}

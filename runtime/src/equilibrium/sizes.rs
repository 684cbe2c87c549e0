//! How large states usually are, as far as an equilibrium and its equations show it.

use nalgebra::DMatrix;

use crate::linear::units;
use crate::motion::{Family, Place};

/// In units in which each state moves the others as much as they move it, a state below this share of the largest is rounding
/// error: what it is tells nothing of how large it usually is.
const TINY: f64 = 1e-12;

/// Newton's steps by which states that all vanish are told to become something.
const STEPS: usize = 4;

/// The sizes of the states at a place, where the design variable is r.
pub(crate) fn sizes_at(family: &Family, r: f64, place: &Place) -> Vec<f64> {
    let velocity = family.at(r).and_then(|flow| flow.velocity(place));
    let Ok(velocity) = velocity else {
        return sizes(&place.state, &DMatrix::zeros(0, 0));
    };
    if place.state.iter().any(|y| *y != 0.0) {
        return sizes(&place.state, &velocity.jacobian);
    }
    // Where all of them vanish, as large as what they rest at; where it is there, as they do once r has changed by itself.
    let rests = velocity.f.iter().all(|rate| *rate == 0.0);
    let change = if r == 0.0 { 1.0 } else { r };
    let beside = led(family, if rests { r + change } else { r }, place);
    let state = beside.unwrap_or_else(|| place.state.clone());
    sizes(&state, &velocity.jacobian)
}

/// Where some of Newton's steps lead.
fn led(family: &Family, r: f64, place: &Place) -> Option<Vec<f64>> {
    let flow = family.at(r).ok()?;
    let mut at = place.clone();
    for _ in 0..STEPS {
        let velocity = flow.velocity(&at).ok()?;
        let step = velocity.jacobian.lu().solve(&velocity.f)?;
        for (y, by) in at.state.iter_mut().zip(&step) {
            *y -= by;
        }
    }
    at.state.iter().all(|y| y.is_finite()).then_some(at.state)
}

/// The sizes of the states where they are these, and where their rates depend on them so: their magnitudes, and of one that
/// vanishes what the others would make of it, or 1 where that is less.
pub(super) fn sizes(state: &[f64], jacobian: &DMatrix<f64>) -> Vec<f64> {
    let mut units = units(jacobian);
    units.resize(state.len(), 1.0);
    let shares = state.iter().zip(&units).map(|(y, unit)| y.abs() / unit);
    let largest = shares.fold(0.0, f64::max);
    let size = |(y, unit): (&f64, &f64)| {
        let usual = if largest > 0.0 { largest * unit } else { 1.0 };
        match y.abs() > TINY * usual {
            true => y.abs(),
            false => usual.min(1.0),
        }
    };
    state.iter().zip(&units).map(size).collect()
}

/// The largest of these sizes, of each state.
pub(crate) fn largest(all: impl Iterator<Item = Vec<f64>>) -> Vec<f64> {
    let larger = |a: Vec<f64>, b: Vec<f64>| a.iter().zip(&b).map(|(a, b)| a.max(*b)).collect();
    all.reduce(larger).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_small_state_is_no_rounding_error_where_it_moves_large_ones() {
        // Displacement, speed and charge of a switch of a micrometre.
        let jacobian = DMatrix::from_row_slice(
            3,
            3,
            &[0.0, 1.0, 0.0, -5e10, -2e4, 2.6e16, 0.0129, 0.0, -1.1e5],
        );
        let [x, v, q] = sizes(&[5.9e-8, 0.0, 2.3e-13], &jacobian)[..] else {
            panic!("three states")
        };
        assert_eq!((x, q), (5.9e-8, 2.3e-13));
        assert!(v > 1e-3 && v < 1.0, "{v}");
    }

    #[test]
    fn what_is_left_of_zero_has_the_size_of_the_rest() {
        let jacobian = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -1.0, 0.0]);
        assert_eq!(sizes(&[0.5, 1e-17], &jacobian), [0.5, 0.5]);
        assert_eq!(sizes(&[0.0, 0.0], &jacobian), [1.0, 1.0]);
    }
}

//! A motion that ends: that fades to an equilibrium, however long its steps' errors let it ring, or hardly moves.

use crate::flow::FlowError;
use crate::linear::eigenvalues;
use crate::motion::{Flow, Place, apart, sticking};

/// Share of what states ever swung by below which what is left of a motion may fade.
const FADED: f64 = 1e-3;
/// How far the equilibrium may be, in what is left of the motion.
const ABOUT: f64 = 10.0;
/// What of a state, or of what it ever swung by, is not told from rounding errors.
const SMALL: f64 = 1e-9;
/// Share of Newton's first step that its second one may be: so little does the field bend on the way.
const STRAIGHT: f64 = 0.1;
/// Newton's steps.
const STEPS: usize = 4;
/// Share of its size, which is at least so much, by which a state that hardly moves moves.
const SLOW: f64 = 1e-3;
const LEAST: f64 = 1e-9;

/// The equilibrium that draws a motion in which swings about it by these extents, after it swung by the widest ones: where
/// nothing sticks, is near, and is stable by all eigenvalues that the field has there.
pub(super) fn fades_to(
    flow: &dyn Flow,
    place: &Place,
    [extents, widest]: [&[f64]; 2],
) -> Option<Vec<f64>> {
    let swings = extents.iter().zip(widest).zip(&place.state);
    let faded = |((extent, widest), y): ((&f64, &f64), &f64)| {
        *extent <= FADED * widest.max(y.abs()) && extent.is_finite()
    };
    if sticking(&place.modes) > 0 || !swings.clone().all(faded) {
        return None;
    }
    let units: Vec<f64> = swings
        .map(|((extent, widest), y)| ABOUT * extent + SMALL * widest.max(y.abs()))
        .collect();
    let mut at = place.clone();
    let mut before = f64::INFINITY;
    for _ in 0..STEPS {
        let velocity = flow.velocity(&at).ok()?;
        let step = velocity.jacobian.lu().solve(&velocity.f)?;
        let next: Vec<f64> = at.state.iter().zip(&step).map(|(y, by)| y - by).collect();
        let length = apart(&next, &at.state, &units);
        // A comparison that fails for NaN too.
        let straight = length <= (STRAIGHT * before).max(STRAIGHT * STRAIGHT);
        if !straight {
            return None;
        }
        (at.state, before) = (next, length);
    }
    let near = apart(&at.state, &place.state, &units) <= 1.0;
    let inside = || flow.margins(&at).iter().all(|(_, margin)| *margin > 0.0);
    let same = || {
        flow.place(&at.state)
            .is_ok_and(|there| there.modes == at.modes)
    };
    let stable = || {
        let jacobian = flow.velocity(&at).ok()?.jacobian;
        let mut all = eigenvalues(&jacobian).into_iter();
        Some(all.all(|one| one.value.re < -one.error(f64::EPSILON)))
    };
    (near && inside() && same() && stable() == Some(true)).then_some(at.state)
}

/// Whether a motion hardly moves over the time that it was watched.
pub(super) fn is_slow(
    flow: &dyn Flow,
    place: &Place,
    extents: &[f64],
    time: f64,
) -> Result<bool, FlowError> {
    let velocity = flow.velocity(place)?.f;
    Ok((0..velocity.len()).all(|j| {
        let size = place.state[j].abs().max(extents[j]).max(LEAST);
        velocity[j].abs() * time <= SLOW * size
    }))
}

//! Where orbits come to one that leaves an equilibrium and comes back to it.

use super::bound::known;
use super::orbit::Orbit;
use crate::continuation::Watched;
use crate::equilibrium::rests;
use crate::flow::Want;
use crate::motion::{Family, apart};

/// Share of r by which it stands still, and of their extents by which orbits do.
const STILL: f64 = 1e-6;
const ALIKE: f64 = 1e-3;
/// An orbit comes as near as this to the equilibrium, in half extents.
const NEAR: f64 = 1e-2;

/// The value of r at which the period of these orbits grows without bound, if it does, as they come ever nearer to a saddle:
/// with the rate λ at which the saddle is left, r − r_h falls like e^(−λT) or faster, so that over a time 1/λ more around
/// neither r nor the orbit changes but for how long it lingers there (Shilnikov).
pub(super) fn homoclinic(family: &Family, orbits: &[Orbit]) -> Option<f64> {
    let last = orbits.last()?;
    let units = last.magnitude();
    let rest = |before: &&Orbit| {
        let still = (before.r - last.r).abs() <= STILL * last.r_size();
        let ends = [(&before.min, &last.min), (&before.max, &last.max)];
        let alike = ends.iter().all(|(a, b)| apart(a, b, &units) <= ALIKE);
        still && alike && before.period < last.period
    };
    let before = orbits.iter().rev().skip(1).take_while(rest).last()?;
    let left = left(family, last, &units)?;
    let longer = last.period - before.period;
    (left * longer >= 1.0).then(|| known(last.r, (before.r - last.r).abs()))
}

/// The rate at which the saddle is left next to which an orbit is calmest; `None` if there is none.
fn left(family: &Family, orbit: &Orbit, units: &[f64]) -> Option<f64> {
    let flow = family.with_magnitude(units).at(orbit.r).ok()?;
    let around = flow.advance(&orbit.place, orbit.period, Want::default());
    let calm = around.ok()?.calm.place;
    let saddle = rests(family, orbit.r, &calm)?;
    let rates = saddle.spectrum.eigenvalues.iter().map(|rate| rate.re);
    let [least, most] = [f64::min, f64::max].map(|far| rates.clone().fold(0.0, far));
    let near = apart(&calm.state, &saddle.place.state, units) <= NEAR;
    (near && least < 0.0 && most > 0.0).then_some(most)
}

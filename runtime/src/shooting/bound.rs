//! Where orbits grow without bound.

use super::orbit::Orbit;

/// Orbits that have grown this many times may grow without bound.
const GROWN: f64 = 1e4;
/// The same where the branch began so near to it, as a share of r, that they were large from the start.
const GROWN_NEAR: f64 = 10.0;
const NEAR: f64 = 1e-5;
/// How many times further away than that the branch began may be, as far as its size tells.
const LAW: f64 = 10.0;
/// How many times smaller the orbits are that those at the end are compared with.
const APART: f64 = 2.0;
/// Share of the way to it to which two extrapolations of where it is agree.
const AGREE: f64 = 0.1;
/// The power of their size whose inverse is smooth: where something comes to a standstill at a fold of rests that open a gap,
/// orbits last as long as the root of the distance is small.
const POWERS: [i32; 2] = [1, 2];
/// What is further away than the end of the range is not met before that, but for what it may be off by.
const BEYOND: f64 = 1.001;

/// Where in a range, at whose ends r stops, these orbits grow without bound, if they do: as at a resonance, or where something
/// comes to a standstill and they last ever longer, the inverse of their size, or of its square, is a smooth function of r that
/// vanishes there.
pub(super) fn unbounded(orbits: &[Orbit], range: [f64; 2]) -> Option<f64> {
    let (first, last) = (orbits.first()?, orbits.last()?);
    let [from, to] = [first, last].map(sizes);
    let growth = |j: &usize| to[*j] / from[*j];
    let most = (0..to.len()).max_by(|i, j| growth(i).total_cmp(&growth(j)))?;
    let grown = growth(&most);
    if grown <= GROWN_NEAR {
        return None;
    }
    let mut seen = orbits
        .iter()
        .rev()
        .map(|orbit| (orbit.r, sizes(orbit)[most]));
    let mut smaller = |size: f64| seen.find(|(_, other)| APART * other <= size);
    let c = smaller(f64::INFINITY)?;
    let b = smaller(c.1)?;
    let a = smaller(b.1)?;
    let met = |power| {
        let [far, near] = [pole(power, b, a), pole(power, c, b)];
        let away = (near - c.0).abs();
        // Along a canard orbits grow as much next to one r; those that grow without bound do so all the way there.
        let began = (first.r - near).abs() <= LAW * grown.powi(power) * away;
        let large = grown > GROWN || away <= NEAR * near.abs() && began;
        let ahead = |end: &&f64| (**end - c.0) * (near - c.0) > 0.0;
        let end = range.iter().find(ahead);
        let end = end.map_or(0.0, |end| (end - c.0).abs());
        let met = away <= BEYOND * end;
        let agree = (near - far).abs();
        (large && met && agree <= AGREE * away).then(|| known(near, agree))
    };
    POWERS.into_iter().find_map(met)
}

/// The digits of a value that are known with such an error.
pub(super) fn known(value: f64, error: f64) -> f64 {
    let unit = 10_f64.powf(error.log10().ceil());
    let rounded = (value / unit).round() * unit;
    if rounded.is_finite() { rounded } else { value }
}

/// Where the inverse of this power of sizes vanishes that two of them, at their r, extrapolate.
fn pole(power: i32, (r, size): (f64, f64), (s, other): (f64, f64)) -> f64 {
    let ratio = (other / size).powi(power);
    (r - s * ratio) / (1.0 - ratio)
}

/// How large an orbit is in each state, and how long it lasts.
fn sizes(orbit: &Orbit) -> Vec<f64> {
    let mut sizes = orbit.magnitude();
    sizes.push(orbit.period);
    sizes
}

//! Where a symmetry is lost, told on orbits that have it.
//!
//! Where two branches cross, the errors of motions part them: an orbit there is off to one side by the cube root of its
//! errors, and what it shows of the crossing by their power 2/3. Orbits that have a symmetry S are not singular there: one that
//! is its own image after half a period is a fixed point of x ↦ S φ(x, T/2), which loses it where that map has the multiplier
//! −1; one that is its own image at once stays among the states that are, and loses it where what they lack, (1 − S)/2 Φ, has
//! the multiplier 1. Either can be told to the accuracy of the motions themselves.

use std::f64::consts::{PI, TAU};

use nalgebra::{DMatrix, DVector};

use super::involution::Symmetry;
use super::kept::NEARLY;
use super::turns::Turns;
use crate::bifurcation::Kind;
use crate::bifurcation::test_function::fold;
use crate::continuation::{Located, Watched, changes};
use crate::flow::Want;
use crate::integrate::Tolerance;
use crate::linear::{eigenvalues, svd};
use crate::motion::{Family, Flow, Place};
use crate::shooting::begin::SHARPER;
use crate::shooting::converge::DOUBT;
use crate::shooting::given::closed;
use crate::shooting::guess::Guess;
use crate::shooting::orbit::{Heading, Orbit};

/// How near, relatively, r turns to where a symmetry is lost.
const TURNED: f64 = 1e-6;
/// Most steps of Newton's method to an orbit, and of the secant to where its symmetry is lost.
const STEPS: usize = 10;
/// First step of the secant, as a share of the size of r.
const STEP: f64 = 1e-5;
/// Closure, in magnitudes of the states, that Newton's method cannot be asked to fall below, and from which on it must.
const CLOSED: f64 = 1e-13;
const CLOSES: f64 = 1e-8;
/// Singular values below this share of the largest belong to directions in which the orbit is free.
const FREE: f64 = 1e-9;
/// Shares of the accuracy to which motions are followed: the second tells the error of the first.
const SHARPEST: [f64; 2] = [0.02, 0.002];

/// Tells a branch point from one at which a symmetry is lost, which orbits that have it tell better where it is. To a branch of
/// those that have none it is a place at which r turns, and they become the images of themselves.
pub(in crate::shooting) fn refine(family: &Family, found: &mut Located<Orbit>, accuracy: f64) {
    // An orbit that cannot be gone around once more has no symmetry that could be told.
    let Ok(Some(symmetry)) = found.point.lost_symmetry(family) else {
        return;
    };
    let turns = found.kind == Kind::Fold;
    let reach = found.error.max(TURNED * found.point.r_size());
    let ends = match turns {
        true => [found.r - reach, found.r + reach],
        false => found.sides.map(|(r, _)| r),
    };
    let lost = lost(family, &found.point, symmetry, ends, accuracy);
    if !turns || lost.is_some() {
        found.kind = Kind::SymmetryBreaking;
    }
    let Some(lost) = lost else { return };
    (found.r, found.error) = (lost.r, lost.error);
    if let Some(orbit) = lost.orbit(family, &found.point, accuracy) {
        (found.point, found.lasting) = (orbit, lost.lasting);
    }
}

/// The orbit between these two at which the symmetry is lost that both have, a multiplier passing through 1, and the errors of r there
/// and of its period.
pub(in crate::shooting) fn lost_between(
    family: &Family,
    ends: [&Orbit; 2],
    accuracy: f64,
) -> Option<(Orbit, [f64; 2])> {
    let [from, to] = ends;
    let critical = |orbit: &Orbit| fold(&orbit.floquet.multipliers);
    let [before, after] = ends.map(critical);
    if !changes(before, after) {
        return None;
    }
    let flow = family.at(from.r).ok()?;
    let nearest = if before.abs() < after.abs() { from } else { to };
    let own = from.own_symmetries(flow.as_ref()).into_iter();
    let mut own = own.filter(|symmetry| to.keeps(family, symmetry, NEARLY) == Some(true));
    let lost =
        own.find_map(|symmetry| lost(family, nearest, symmetry, [from.r, to.r], accuracy))?;
    let orbit = lost.orbit(family, nearest, accuracy)?;
    Some((orbit, [lost.error, lost.lasting]))
}

/// Where orbits lose a symmetry that this one has, or nearly so, if it is between these values of r.
fn lost(
    family: &Family,
    orbit: &Orbit,
    symmetry: (Symmetry, bool),
    [from, to]: [f64; 2],
    accuracy: f64,
) -> Option<Lost> {
    let magnitude = orbit.magnitude();
    let turns = orbit.turns(family.at(orbit.r).ok()?.as_ref());
    let symmetric = Symmetric::of(orbit, symmetry, (&magnitude, turns));
    let near = (orbit.r, orbit.r_size().max((to - from).abs()));
    let lost = symmetric.lost(family, near, accuracy)?;
    ((lost.r - from) * (lost.r - to) <= 0.0).then_some(lost)
}

/// Where an orbit loses its symmetry.
#[derive(Debug, Clone)]
struct Lost {
    r: f64,
    /// Its estimated error.
    error: f64,
    /// Where the orbit begins there.
    start: Place,
    period: f64,
    /// The estimated error of its period, by that of r.
    lasting: f64,
}

impl Lost {
    /// The orbit there, on the branch of one beside it.
    fn orbit(&self, family: &Family, beside: &Orbit, accuracy: f64) -> Option<Orbit> {
        let guess = Guess {
            place: self.start.clone(),
            period: self.period,
            division: None,
            ..beside.guess()
        };
        let sharp = family
            .with_tolerance(Tolerance::for_accuracy(SHARPER * accuracy))
            .with_magnitude(&guess.magnitude);
        let orbit = closed(&sharp, self.r, &guess, (accuracy, 1))?;
        let heading = Heading {
            start: orbit.heading.start.clone(),
            ..beside.heading.clone()
        };
        Some(Orbit {
            heading,
            work: beside.work,
            error_estimate: beside.error_estimate,
            ..orbit
        })
    }
}

/// An orbit that is its own image, at once or after half its period.
#[derive(Debug, Clone)]
struct Symmetric<'a> {
    symmetry: Symmetry,
    /// Whether that is so after half its period.
    halfway: bool,
    magnitude: &'a [f64],
    turns: Turns,
    start: Place,
    /// Half its period, or all of it.
    span: f64,
}

impl<'a> Symmetric<'a> {
    /// An orbit that has this symmetry, or nearly so.
    fn of(
        orbit: &Orbit,
        (symmetry, halfway): (Symmetry, bool),
        (magnitude, turns): (&'a [f64], Turns),
    ) -> Self {
        let mut start = orbit.begins().clone();
        if !halfway {
            start.state = symmetry.kept(&start.state);
        }
        Self {
            symmetry,
            halfway,
            magnitude,
            turns,
            start,
            span: if halfway { 0.5 } else { 1.0 } * orbit.period,
        }
    }

    /// Where it loses its symmetry, next to r, which is of this size.
    fn lost(mut self, family: &Family, (r, size): (f64, f64), accuracy: f64) -> Option<Lost> {
        let [usual, sharper] = SHARPEST.map(|share| {
            let tolerance = Tolerance::for_accuracy(share * accuracy);
            family.with_tolerance(tolerance)
        });
        let mut before = (r, self.multiplier(&usual, r)?, self.period());
        let mut r = r + STEP * size;
        for _ in 0..STEPS {
            let value = self.multiplier(&usual, r)?;
            let slope = (value - before.1) / (r - before.0);
            let off = value / slope;
            if off.abs() <= accuracy * size {
                let again = self.multiplier(&sharper, r)?;
                let error = DOUBT * ((again - value) / slope).abs() + SHARPEST[0] * accuracy * size;
                if !(off.is_finite() && error.is_finite()) {
                    return None;
                }
                let longer = (self.period() - before.2) / (r - before.0);
                r -= off;
                self.multiplier(&sharper, r)?;
                return Some(Lost {
                    r,
                    error,
                    period: self.period(),
                    start: self.start,
                    lasting: longer.abs() * error,
                });
            }
            before = (r, value, self.period());
            r -= off;
        }
        None
    }

    fn period(&self) -> f64 {
        if self.halfway {
            2.0 * self.span
        } else {
            self.span
        }
    }

    /// 1 ∓ μ at r, μ being the critical multiplier of what S changes; the orbit is followed there.
    fn multiplier(&mut self, family: &Family, r: f64) -> Option<f64> {
        let flow = family.with_magnitude(self.magnitude).at(r).ok()?;
        if let Some(phase) = flow.phase() {
            let omega = flow.velocity(&self.start).ok()?.f[phase];
            let turn = if self.halfway { PI } else { TAU };
            self.span = turn * (self.span * omega / turn).round() / omega;
        }
        let map = self.close(flow.as_ref())?;
        let (map, sign) = match self.halfway {
            true => (map, 1.0),
            false => (self.symmetry.part(-1.0) * map, -1.0),
        };
        let off = |one: f64| 1.0 + sign * one;
        let all = eigenvalues(&map).into_iter().map(|one| one.value);
        let real = all.filter(|one| one.im == 0.0).map(|one| off(one.re));
        real.min_by(|a, b| a.abs().total_cmp(&b.abs()))
    }

    /// Newton's method to an orbit that closes, and its map there.
    fn close(&mut self, flow: &dyn Flow) -> Option<DMatrix<f64>> {
        let order = self.magnitude.len();
        let matrix = match self.halfway {
            true => self.symmetry.matrix(),
            false => DMatrix::identity(order, order),
        };
        let mut last = f64::INFINITY;
        for _ in 0..STEPS {
            let passage = flow.advance(&self.start, self.span, Want::DERIVATIVES);
            let passage = passage.ok()?;
            let along = passage.derivatives?;
            let map = &matrix * along.state;
            let miss = self.miss(&passage.end);
            let size = miss.amax();
            if size <= CLOSED || (size <= CLOSES && size >= last) {
                return Some(map);
            }
            self.improve(flow, &map, &(&matrix * along.time), &miss)?;
            last = size;
        }
        None
    }

    /// By how much the start lacks what comes back to it, in magnitudes.
    fn miss(&self, end: &Place) -> DVector<f64> {
        let image = match self.halfway {
            true => self.symmetry.of(&end.state),
            false => end.state.clone(),
        };
        let off = |j: usize| self.turns.rest(j, image[j] - self.start.state[j]) / self.magnitude[j];
        DVector::from_fn(image.len(), |j, _| off(j))
    }

    /// One step of Newton's method, the least of those that do it: along the orbit it is free. A drive keeps its phase and
    /// its time.
    fn improve(
        &mut self,
        flow: &dyn Flow,
        map: &DMatrix<f64>,
        time: &DVector<f64>,
        miss: &DVector<f64>,
    ) -> Option<()> {
        let (order, phase) = (miss.len(), flow.phase());
        let slope = |i: usize, j: usize| match (j == order, phase) {
            (true, None) => time[i] * self.span / self.magnitude[i],
            (true, Some(_)) => 0.0,
            (false, phase) if phase == Some(j) => 0.0,
            _ => (map[(i, j)] - f64::from(i == j)) * self.magnitude[j] / self.magnitude[i],
        };
        let svd = svd(DMatrix::from_fn(order, order + 1, slope))?;
        let least = FREE * svd.singular_values.max();
        let step = svd.solve(miss, least).ok()?;
        for (j, state) in self.start.state.iter_mut().enumerate() {
            *state -= step[j] * self.magnitude[j];
        }
        if !self.halfway {
            self.start.state = self.symmetry.kept(&self.start.state);
        }
        self.span *= 1.0 - step[order];
        Some(())
    }
}

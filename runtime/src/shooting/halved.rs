//! Where a symmetry is lost, told on orbits that have it.
//!
//! Where two branches cross, the errors of motions part them: an orbit there is off to one side by the cube root of its
//! errors, and what it shows of the crossing by their power 2/3. One that is its own image after half a period is a fixed
//! point of x ↦ S φ(x, T/2), S being the symmetry, and is not singular there: a symmetry is lost where that map has the
//! multiplier −1, which can be told to the accuracy of the motions themselves.

use std::f64::consts::{PI, TAU};

use nalgebra::{DMatrix, DVector};

use super::converge::DOUBT;
use super::orbit::Orbit;
use super::symmetry::Symmetry;
use crate::flow::Want;
use crate::integrate::Tolerance;
use crate::linear::{eigenvalues, svd};
use crate::motion::{Family, Flow, Place};

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
const SHARPER: [f64; 2] = [0.02, 0.002];

/// Where an orbit loses its symmetry.
#[derive(Debug, Clone)]
pub(super) struct Lost {
    pub(super) r: f64,
    /// Its estimated error.
    pub(super) error: f64,
    /// Where the orbit begins there.
    pub(super) start: Place,
    pub(super) period: f64,
    /// The estimated error of its period, by that of r.
    pub(super) lasting: f64,
}

/// An orbit that is its own image after half its period.
#[derive(Debug, Clone)]
pub(super) struct Halved<'a> {
    symmetry: Symmetry,
    magnitude: &'a [f64],
    start: Place,
    /// Half its period.
    half: f64,
}

impl<'a> Halved<'a> {
    /// An orbit that has this symmetry, or nearly so.
    pub(super) fn of(orbit: &Orbit, symmetry: Symmetry, magnitude: &'a [f64]) -> Self {
        let start = orbit.begins();
        Self {
            symmetry,
            magnitude,
            start: start.clone(),
            half: 0.5 * orbit.period,
        }
    }

    /// Where it loses its symmetry, next to r, which is of this size.
    pub(super) fn lost(
        mut self,
        family: &Family,
        (r, size): (f64, f64),
        accuracy: f64,
    ) -> Option<Lost> {
        let [usual, sharper] = SHARPER.map(|share| {
            let tolerance = Tolerance::for_accuracy(share * accuracy);
            family.with_tolerance(tolerance)
        });
        let mut before = (r, self.multiplier(&usual, r)?, self.half);
        let mut r = r + STEP * size;
        for _ in 0..STEPS {
            let value = self.multiplier(&usual, r)?;
            let slope = (value - before.1) / (r - before.0);
            let off = value / slope;
            if off.abs() <= accuracy * size {
                let again = self.multiplier(&sharper, r)?;
                let error = DOUBT * ((again - value) / slope).abs() + SHARPER[0] * accuracy * size;
                if !(off.is_finite() && error.is_finite()) {
                    return None;
                }
                let longer = 2.0 * (self.half - before.2) / (r - before.0);
                r -= off;
                self.multiplier(&sharper, r)?;
                return Some(Lost {
                    r,
                    error,
                    start: self.start,
                    period: 2.0 * self.half,
                    lasting: longer.abs() * error,
                });
            }
            before = (r, value, self.half);
            r -= off;
        }
        None
    }

    /// 1 + μ at r, μ being that multiplier of the half map which is nearest to −1; the orbit is followed there.
    fn multiplier(&mut self, family: &Family, r: f64) -> Option<f64> {
        let flow = family.with_magnitude(self.magnitude).at(r).ok()?;
        if let Some(phase) = flow.phase() {
            let omega = flow.velocity(&self.start).ok()?.f[phase];
            self.half = PI * (self.half * omega / PI).round() / omega;
        }
        let map = self.close(flow.as_ref())?;
        let near = |one: &f64| (1.0 + one).abs();
        let all = eigenvalues(&map).into_iter().map(|one| one.value);
        let real = all.filter(|one| one.im == 0.0).map(|one| one.re);
        real.min_by(|a, b| near(a).total_cmp(&near(b)))
            .map(|one| 1.0 + one)
    }

    /// Newton's method to an orbit that closes, and its half map there.
    fn close(&mut self, flow: &dyn Flow) -> Option<DMatrix<f64>> {
        let matrix = self.symmetry.matrix();
        let mut last = f64::INFINITY;
        for _ in 0..STEPS {
            let passage = flow.advance(&self.start, self.half, Want::DERIVATIVES);
            let passage = passage.ok()?;
            let along = passage.derivatives?;
            let map = &matrix * along.state;
            let miss = self.miss(flow, &passage.end);
            let size = miss.amax();
            if size <= CLOSED || (size <= CLOSES && size >= last) {
                return Some(map);
            }
            self.improve(flow, &map, &(&matrix * along.time), &miss)?;
            last = size;
        }
        None
    }

    /// By how much the start lacks its image after half a period, in magnitudes.
    fn miss(&self, flow: &dyn Flow, end: &Place) -> DVector<f64> {
        let image = self.symmetry.of(&end.state);
        let off = |j: usize| {
            let off = image[j] - self.start.state[j];
            let turns = if flow.phase() == Some(j) {
                (off / TAU).round()
            } else {
                0.0
            };
            (off - TAU * turns) / self.magnitude[j]
        };
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
            (true, None) => time[i] * self.half / self.magnitude[i],
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
        self.half *= 1.0 - step[order];
        Some(())
    }
}

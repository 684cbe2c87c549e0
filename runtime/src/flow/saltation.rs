//! Derivatives through an event: the saltation matrix of Aizerman and Gantmakher (1958).

use super::Determinant;
use crate::field::Caught;
use crate::integrate::{Carried, Motion};
use crate::scalar::{dot, mapped};

/// Rate of a guard, relative to its gradient and to the field, which is nothing but rounding error.
const ROUNDING: f64 = 1e-14;
/// Relative jump of the field below which nothing jumps.
const NO_JUMP: f64 = 1e-12;

/// The surface h = 0 on which the field changes from `before` to `after`; the state does not jump.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Saltation<const N: usize> {
    /// f⁻.
    pub(crate) before: [f64; N],
    /// f⁺.
    pub(crate) after: [f64; N],
    /// h_y.
    pub(crate) gradient: [f64; N],
    /// h_r.
    pub(crate) design: f64,
    /// Usual magnitudes of the states: in these, fields and gradients of different units add up.
    pub(crate) magnitude: [f64; N],
}

impl<const N: usize> Saltation<N> {
    /// Takes Φ and p from before the event to after it; what that makes of volumes, (h_y f⁺)/(h_y f⁻).
    ///
    /// # Errors
    /// D = h_y f⁻, if the motion `grazes` the surface instead of crossing it and the field jumps there.
    pub(crate) fn apply(&self, motion: &mut Motion<N>, grazes: bool) -> Result<Passed, f64> {
        let jump: [f64; N] = crate::scalar::filled(|i| self.after[i] - self.before[i]);
        if self.size(&jump) <= NO_JUMP * (self.size(&self.before) + self.size(&self.after)) {
            return Ok(Passed::default());
        }
        let (shift, shifts) = self.shifts(motion, grazes)?;
        leap(motion, &jump, shift, &shifts);
        Ok(self.passed(&jump, self.stretch()))
    }

    /// The same where the state jumps as well: Ξ = R_y + (f⁺ − R_y f⁻) h_y/(h_y f⁻) with the reset R. It leaves h as it is,
    /// so that h_y R_y = h_y and det Ξ = det R_y (h_y f⁺)/(h_y f⁻).
    ///
    /// # Errors
    /// As [`Saltation::apply`].
    pub(crate) fn reset(
        &self,
        motion: &mut Motion<N>,
        reset: &Reset<N>,
        grazes: bool,
    ) -> Result<Passed, f64> {
        let jump = crate::scalar::filled(|i| self.after[i] - dot(&reset.slopes[i], &self.before));
        let (shift, shifts) = self.shifts(motion, grazes)?;
        motion.design =
            crate::scalar::filled(|i| dot(&reset.slopes[i], &motion.design) + reset.design[i]);
        motion.tangent = product(&reset.slopes, &motion.tangent);
        leap(motion, &jump, shift, &shifts);
        let volumes = Determinant::of_matrix(reset.slopes).times(self.stretch());
        Ok(self.passed(&jump, volumes))
    }

    /// What passing does, with this jump of the field.
    fn passed(&self, jump: &[f64; N], volumes: Determinant) -> Passed {
        let rate = dot(&self.gradient, &self.before);
        Passed {
            volumes,
            leap: self.size(jump) / rate.abs(),
        }
    }

    /// (h_y f⁺)/(h_y f⁻): zero where the motion stays on the surface.
    fn stretch(&self) -> Determinant {
        let [before, after] = [&self.before, &self.after].map(|f| dot(&self.gradient, f));
        if after.abs() <= ROUNDING * self.slope() * self.size(&self.after) {
            return Determinant::ZERO;
        }
        Determinant::of(after / before)
    }

    /// The size of a field.
    fn size(&self, field: &[f64; N]) -> f64 {
        norm::<N>(&crate::scalar::filled(|i| field[i] / self.magnitude[i]))
    }

    /// The size of h_y.
    fn slope(&self) -> f64 {
        norm::<N>(&crate::scalar::filled(|i| {
            self.gradient[i] * self.magnitude[i]
        }))
    }

    /// (h_y p + h_r)/(h_y f⁻) and h_y Φ/(h_y f⁻).
    fn shifts(&self, motion: &Motion<N>, grazes: bool) -> Result<(f64, [f64; N]), f64> {
        let rate = dot(&self.gradient, &self.before);
        // A comparison that fails for NaN too.
        let crosses = rate.abs() > ROUNDING * self.slope() * self.size(&self.before);
        if grazes || !crosses {
            return Err(rate);
        }
        let shift = (dot(&self.gradient, &motion.design) + self.design) / rate;
        let mut shifts = [0.0; N];
        for (row, slope) in motion.tangent.iter().zip(&self.gradient) {
            shifts.add(slope / rate, row);
        }
        Ok((shift, shifts))
    }
}

/// Adds a jump in each direction by as much as time is shifted there.
fn leap<const N: usize>(motion: &mut Motion<N>, jump: &[f64; N], shift: f64, shifts: &[f64; N]) {
    motion.design.add(shift, jump);
    for (row, leap) in motion.tangent.iter_mut().zip(jump) {
        row.add(*leap, shifts);
    }
}

/// What passing an event does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Passed {
    /// What it makes of volumes.
    pub(crate) volumes: Determinant,
    /// How far off it puts the state, in its usual magnitudes, for each unit by which h is off.
    pub(crate) leap: f64,
}

impl Default for Passed {
    fn default() -> Self {
        Self {
            volumes: Determinant::ONE,
            leap: 0.0,
        }
    }
}

/// The derivatives of a jump of the state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Reset<const N: usize> {
    /// R_y, row by row.
    pub(crate) slopes: [[f64; N]; N],
    /// R_r.
    pub(crate) design: [f64; N],
}

/// A state z caught by its stop b: f jumps in its row alone, from g to 0, so that with h = b − z the formula is
/// Ξ = I − e_z e_zᵀ whatever g is, and p_z⁺ = ±b_r: where z came from is forgotten.
pub(super) fn catch<const N: usize>(motion: &mut Motion<N>, caught: Caught) {
    motion.tangent[caught.state] = [0.0; N];
    motion.design[caught.state] = caught.along;
}

/// A B.
pub(super) fn product<const N: usize>(a: &[[f64; N]; N], b: &[[f64; N]; N]) -> [[f64; N]; N] {
    mapped(a, |row| {
        let mut sum = [0.0; N];
        for (entry, other) in row.iter().zip(b) {
            sum.add(*entry, other);
        }
        sum
    })
}

fn norm<const N: usize>(a: &[f64; N]) -> f64 {
    dot(a, a).sqrt()
}

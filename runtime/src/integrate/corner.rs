//! Corners of the field inside an explicit step: steps end on them.

use super::IntegrationError;
use super::carried::Carried;
use super::event::Bernstein;
use super::stepper::Stepper;
use crate::field::Field;
use crate::scalar::mapped;

/// A corner this near to the beginning of a step, as a share of what its function changes by, has been left behind.
const LEFT_BEHIND: f64 = 1e-9;
/// Trials of the step map; each divides the bracket by far more than two, as a rule.
const TRIALS: usize = 40;
/// Width of the bracket, as a share of the step, at which the corner is found.
const FOUND: f64 = 1e-14;
/// Rounding error of an interpolated guard, relative to its terms.
const NOISE: f64 = 128.0 * f64::EPSILON;

impl<F: Field<N>, V: Carried<N>, const N: usize> Stepper<'_, F, V, N> {
    /// Ends an accepted step on the first corner of the field inside it; [`Stepper::fallen`] tells whether it is a guard.
    ///
    /// # Errors
    /// The field is not finite on the way.
    pub fn stop_at_corner(&mut self) -> Result<(), IntegrationError> {
        let mut shorter = None;
        self.fallen = None;
        let guards = |index: &usize| self.field.guard(*index).is_some();
        let fall = if (0..self.field.corners()).any(|index| guards(&index)) {
            self.first_fall()
        } else {
            None
        };
        for index in 0..self.field.corners() {
            if self.field.guard(index).is_some() {
                continue;
            }
            let length = shorter.unwrap_or(self.length());
            let end = if shorter.is_some() {
                self.step_map(length)
            } else {
                *self.end().state()
            };
            let (a, b) = (
                self.field.kink(index, self.from().state()),
                self.field.kink(index, &end),
            );
            if a * b < 0.0 && a.abs() > LEFT_BEHIND * (a - b).abs() {
                shorter = Some(self.locate_corner(index, length, a, b));
            }
        }
        if let Some((index, length)) = fall
            && shorter.is_none_or(|corner| length <= corner)
        {
            (self.fallen, shorter) = (Some(index), Some(length));
        }
        match shorter {
            Some(length) => self.shorten(length),
            None => Ok(()),
        }
    }

    /// The first guard that falls inside the step, and the length at which it does.
    fn first_fall(&mut self) -> Option<(usize, f64)> {
        let (dense, nodes, length) = (self.dense(), Bernstein::nodes(), self.length());
        let mut first: Option<(usize, f64, f64)> = None;
        for index in 0..self.field.corners() {
            let Some(terms) = self.field.guard(index) else {
                continue;
            };
            let values = mapped(&nodes, |theta| self.field.kink(index, &dense.state(theta)));
            let guard = Bernstein::interpolate(&values);
            let noise = NOISE * terms.max(guard.magnitude());
            if let Some((theta, until)) = guard.without_noise(noise).first_fall()
                && first.is_none_or(|(_, earliest, _)| theta < earliest)
            {
                first = Some((index, theta, until));
            }
        }
        let (index, _, until) = first?;
        let from = self.field.kink(index, self.from().state()).max(0.0);
        // What falls on the polynomial alone is a touch, unless it is down at the end.
        for high in [until * length, length] {
            let to = self.field.kink(index, &self.step_map(high));
            if to < 0.0 {
                return Some((index, self.locate_corner(index, high, from, to)));
            }
        }
        None
    }

    /// The length at which kink function `index` vanishes, between its values a at 0 and b at `length`.
    fn locate_corner(&mut self, index: usize, length: f64, a: f64, b: f64) -> f64 {
        let (mut low, mut high, mut at_low, mut at_high) = (0.0, length, a, b);
        let mut side = 0;
        for _ in 0..TRIALS {
            let secant = low + (high - low) * at_low / (at_low - at_high);
            let inside = secant > low && secant < high;
            let middle = if inside { secant } else { 0.5 * (low + high) };
            let state = self.step_map(middle);
            let value = self.field.kink(index, &state);
            // The Illinois rule: an end that stays twice counts half.
            let before = if self.field.guard(index).is_some() {
                value > 0.0
            } else {
                value * a > 0.0
            };
            if before {
                (low, at_low) = (middle, value);
                at_high *= if side == 1 { 0.5 } else { 1.0 };
                side = 1;
            } else {
                (high, at_high) = (middle, value);
                at_low *= if side == -1 { 0.5 } else { 1.0 };
                side = -1;
            }
            if value == 0.0 || high - low <= FOUND * length {
                break;
            }
        }
        high
    }
}

//! Kinks of the field inside a step: steps end on them.

use super::super::collocation::Collocation;
use super::super::event::Bernstein;
use super::stages::Trial;
use super::{Radau, add};
use crate::field::Field;
use crate::scalar::mapped;

/// A kink function this small means that the kink is reached; this large, that it was missed.
const KINK_REACHED: f64 = 1e-7;
const KINK_MISSED: f64 = 1e-4;
/// A guard decides what comes next: it is taken to where rounding ends.
const GUARD_REACHED: f64 = 1e-13;
const SECANTS: usize = 6;
/// Error of an interpolated guard, relative to it: what the stage equations leave.
const NOISE: f64 = 1e-9;

/// What a step meets.
pub(super) enum Kink<const N: usize, const S: usize> {
    /// No kink of the field.
    None,
    /// A kink, at which this shorter step ends.
    At(Trial<N, S>),
    /// A kink at about this fraction, to which no step leads: the step has jumped something.
    Missed(f64),
}

impl<F: Field<N>, const N: usize, const S: usize> Radau<'_, F, N, S> {
    /// Looks for the first kink of the field inside a step.
    pub(super) fn stop_at_kink(
        &mut self,
        trial: &Trial<N, S>,
        collocation: &Collocation<N, S>,
    ) -> Kink<N, S> {
        let (start, end) = (trial.start, trial.end());
        let mut first: Option<(f64, usize, f64)> = None;
        self.fallen = None;
        for index in 0..self.field.kinks() {
            if self.field.guard(index).is_some() {
                if let Some((theta, size)) = self.fall(index, &start, collocation)
                    && first.is_none_or(|(earliest, ..)| theta < earliest)
                {
                    first = Some((theta, index, size));
                }
                continue;
            }
            let (a, b) = (self.field.kink(index, &start), self.field.kink(index, &end));
            let size = self.field.kink_size(index, a, b);
            if a.abs() > KINK_REACHED * size && a * b < 0.0 {
                let theta = bisect(
                    |theta| self.field.kink(index, &add(&start, &collocation.at(theta))),
                    a,
                );
                if first.is_none_or(|(earliest, ..)| theta < earliest) {
                    first = Some((theta, index, size));
                }
            }
        }
        let Some(first @ (theta, ..)) = first else {
            return Kink::None;
        };
        match self.locate_kink(trial, collocation, first) {
            Some(shorter) => {
                self.fallen = Some(first.1).filter(|index| self.field.guard(*index).is_some());
                Kink::At(shorter)
            }
            None => Kink::Missed(theta),
        }
    }

    /// Where guard number `index` first falls along the polynomial, and how large it is there.
    fn fall(
        &self,
        index: usize,
        start: &[f64; N],
        collocation: &Collocation<N, S>,
    ) -> Option<(f64, f64)> {
        let along = |theta: f64| self.field.kink(index, &add(start, &collocation.at(theta)));
        let guard = Bernstein::interpolate(&mapped(&Bernstein::nodes(), along));
        let size = guard.magnitude();
        let (theta, _) = guard.without_noise(NOISE * size).first_fall()?;
        Some((theta, size))
    }

    /// The step to kink number `index`, which the polynomial sees at `theta`, and whose function has this size.
    fn locate_kink(
        &mut self,
        trial: &Trial<N, S>,
        collocation: &Collocation<N, S>,
        (theta, index, size): (f64, usize, f64),
    ) -> Option<Trial<N, S>> {
        let along = |theta: f64| add(&trial.start, &collocation.at(theta));
        let mut shorter = self.solve_within(trial, collocation, theta)?;
        // One secant step on the step map, of a guard some more; the polynomial supplies the first slope.
        let mut value = self.field.kink(index, &shorter.end());
        let nearby = self.field.kink(index, &along(theta * (1.0 - 1e-4)));
        let mut slope = (self.field.kink(index, &along(theta)) - nearby) / (1e-4 * theta);
        let (near, secants) = match self.field.guard(index) {
            Some(_) => (GUARD_REACHED, SECANTS),
            None => (KINK_REACHED, 1),
        };
        let mut at = theta;
        for _ in 0..secants {
            let better = at - value / slope;
            if value.abs() <= near * size || !(better > 0.0 && better < 1.0) {
                break;
            }
            shorter = self.solve_within(trial, collocation, better)?;
            let there = self.field.kink(index, &shorter.end());
            slope = (there - value) / (better - at);
            (at, value) = (better, there);
        }
        // The stage equations have other solutions that leave a layer at once; they fail here.
        let reached = self.field.kink(index, &shorter.end()).abs() <= KINK_MISSED * size;
        (reached && self.error(&shorter) <= 1.0).then_some(shorter)
    }
}

/// Where along [0, 1] a function that starts at `from` ≠ 0 and ends with the other sign vanishes.
fn bisect(value: impl Fn(f64) -> f64, from: f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        if value(middle) * from > 0.0 {
            low = middle
        } else {
            high = middle
        }
    }
    0.5 * (low + high)
}

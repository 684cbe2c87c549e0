//! Sign changes of polynomials inside a step, isolated without a miss, and their polishing on the step map.

pub use super::bernstein::Bernstein;
use super::bernstein::DEGREE;

/// Subdivisions after which a pair of roots is taken for a touch.
const DEPTH: u32 = 40;

/// Rounds of polishing; bisection alone needs about fifty to exhaust the digits.
const ROUNDS: usize = 80;

/// Steps of polishing shorter than this part of the bracket are the last: what is left is their square.
const LAST_STEP: f64 = 1e-9;

/// A place where a polynomial changes sign.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SignChange {
    /// Where in [0, 1].
    pub theta: f64,
    /// Whether it rises there.
    pub rising: bool,
}

/// The sign changes of one polynomial in the order of θ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SignChanges {
    found: [SignChange; DEGREE],
    count: usize,
    sign: f64,
}

impl Bernstein {
    /// Where a polynomial that is known to be positive just after 0 first becomes negative, and a place
    /// after that, or 1, up to which it stays so.
    #[must_use]
    pub fn first_fall(&self) -> Option<(f64, f64)> {
        if self.lower_bound() >= 0.0 {
            return None;
        }
        let changes = self.changes(1.0);
        let fall = changes.iter().find(|change| !change.rising)?.theta;
        let rise = changes.iter().find(|change| change.rising);
        let until = rise.map_or(1.0, |change| 0.5 * (fall + change.theta));
        Some((fall, until))
    }

    /// Its signs just after 0 and just before 1; `None` if it vanishes.
    #[must_use]
    pub fn end_signs(&self) -> Option<(f64, f64)> {
        self.signs().map(|(first, last, _)| (first, last))
    }

    /// All sign changes in [0, 1]; a double root is none.
    #[must_use]
    pub fn sign_changes(&self) -> SignChanges {
        self.changes(0.0)
    }

    fn changes(&self, sign: f64) -> SignChanges {
        let nowhere = SignChange {
            theta: 0.0,
            rising: false,
        };
        let mut changes = SignChanges {
            found: [nowhere; DEGREE],
            count: 0,
            sign,
        };
        self.isolate(0.0, 1.0, DEPTH, &mut changes);
        changes
    }

    /// Halves the interval until each half has no sign change of its coefficients or exactly one.
    fn isolate(&self, from: f64, width: f64, depth: u32, changes: &mut SignChanges) {
        let Some((first, last, variations)) = self.signs() else {
            return;
        };
        // A root exactly at the seam of two halves shows in neither of them, only in the sign left behind.
        changes.enter(from, first);
        if variations > 1 && depth > 0 {
            let (left, right) = self.halves();
            left.isolate(from, 0.5 * width, depth - 1, changes);
            right.isolate(from + 0.5 * width, 0.5 * width, depth - 1, changes);
        } else if first != last {
            changes.enter(from + width * self.single_root(first), last);
        }
    }

    /// Signs of the first and last coefficients that do not vanish, and the number of sign variations; `None` if all
    /// vanish, or if any is no number: halves of such a polynomial vary as often as the whole, without an end.
    fn signs(&self) -> Option<(f64, f64, usize)> {
        if self.coefficients().iter().any(|c| c.is_nan()) {
            return None;
        }
        let mut signs = self
            .coefficients()
            .iter()
            .filter(|c| **c != 0.0)
            .map(|c| c.signum());
        let first = signs.next()?;
        let (mut last, mut variations) = (first, 0);
        for sign in signs {
            variations += usize::from(sign != last);
            last = sign;
        }
        Some((first, last, variations))
    }

    /// De Casteljau's subdivision at ½.
    fn halves(&self) -> (Self, Self) {
        let (mut left, mut right) = (*self, *self);
        for level in 0..=self.degree {
            left.coefficients[level] = right.coefficients[0];
            for j in 0..self.degree - level {
                right.coefficients[j] = 0.5 * (right.coefficients[j] + right.coefficients[j + 1]);
            }
        }
        (left, right)
    }

    /// The root between ends of different sign, `first` being the sign at 0.
    fn single_root(&self, first: f64) -> f64 {
        // An end that is a root itself is not the one between.
        let [a, b] = [0, self.degree].map(|end| self.coefficients[end].abs());
        let guess = if a > 0.0 && b > 0.0 { a / (a + b) } else { 0.5 };
        polish(0.0, 1.0, guess, |theta| {
            let (value, slope) = self.value_and_slope(theta);
            (first * value, first * slope)
        })
    }
}

impl SignChanges {
    /// In the order of θ.
    pub fn iter(&self) -> impl Iterator<Item = &SignChange> {
        self.found.iter().take(self.count)
    }

    fn enter(&mut self, theta: f64, sign: f64) {
        if self.sign * sign < 0.0
            && let Some(place) = self.found.get_mut(self.count)
        {
            let rising = sign > 0.0;
            *place = SignChange { theta, rising };
            self.count += 1;
        }
        self.sign = sign;
    }
}

/// Locates the fall of g through zero between `from`, where it is positive, and `to`, where it is not,
/// by Newton's method kept inside the shrinking bracket; `g` gives value and slope.
pub fn polish(from: f64, to: f64, guess: f64, mut g: impl FnMut(f64) -> (f64, f64)) -> f64 {
    let (mut low, mut high, mut x) = (from, to, guess);
    for _ in 0..ROUNDS {
        let (value, slope) = g(x);
        if value == 0.0 {
            return x;
        }
        *(if value > 0.0 { &mut low } else { &mut high }) = x;
        let newton = x - value / slope;
        let inside = slope < 0.0 && low <= newton && newton <= high;
        let next = if inside { newton } else { 0.5 * (low + high) };
        let converged = inside && (next - x).abs() <= LAST_STEP * (to - from);
        let exhausted = high - low <= 2.0 * f64::EPSILON * high.abs();
        if converged || exhausted {
            return next;
        }
        x = next;
    }
    x
}

#[cfg(test)]
mod tests;

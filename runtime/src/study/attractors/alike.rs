//! Whether two computations have found the same motion.

use super::record::{Attractor, Class};
use crate::motion::{apart, half_extents};
use crate::shooting::{slid, unshifted};

/// Points of two computations of one motion agree to this share of its extent.
const SAME: f64 = 1e-5;
/// Bounds and means of one irregular motion, known from different starts, agree to this share of its extent.
const ALIKE: f64 = 0.1;

impl Attractor {
    /// Half its extent, state by state; `fallback` where it has none.
    pub(super) fn magnitude(&self, fallback: &[f64]) -> Vec<f64> {
        half_extents(&self.min, &self.max, fallback)
    }

    /// Whether two computations have found the same motion; states that hardly move are measured against `usual` sizes.
    pub(super) fn is(&self, other: &Self, usual: &[f64]) -> bool {
        if self.class != other.class {
            return false;
        }
        let units = self.magnitude(usual);
        match self.class {
            Class::Equilibrium => apart(&self.state, &other.state, usual) <= SAME,
            Class::Sticking => self.modes == other.modes,
            Class::Orbit => self.coincides(other, &units),
            Class::Running => self.runs_like(other, usual) && self.coincides(other, &units),
            Class::Torus | Class::Chaos => {
                apart(&self.state, &other.state, &units)
                    .max(apart(&self.min, &other.min, &units))
                    .max(apart(&self.max, &other.max, &units))
                    <= ALIKE
            }
            Class::Family => self.word == other.word,
            Class::Escape | Class::Unsettled => true,
            Class::Failed => self.fails_like(other),
        }
    }

    /// Whether both fail for one reason, whatever its numbers are.
    fn fails_like(&self, other: &Self) -> bool {
        let words = |one: &Self| -> Vec<String> {
            let reason = one
                .reason
                .iter()
                .flat_map(|reason| reason.split_whitespace());
            let bare = reason.map(|word| word.trim_matches(|c: char| !c.is_alphanumeric()));
            let words = bare.filter(|word| word.parse::<f64>().is_err());
            words.map(str::to_owned).collect()
        };
        words(self) == words(other)
    }

    /// Whether both advance as much.
    fn runs_like(&self, other: &Self, usual: &[f64]) -> bool {
        match (&self.shift, &other.shift) {
            (Some(a), Some(b)) => apart(a, b, usual) <= SAME,
            _ => false,
        }
    }

    /// Whether both meet their section in the same points, in turn.
    fn coincides(&self, other: &Self, units: &[f64]) -> bool {
        let count = self.points.len();
        let periods = [self, other].map(|one| one.period.unwrap_or(0.0));
        let near = |turn: usize| {
            let pairs = self
                .points
                .iter()
                .zip(other.points.iter().cycle().skip(turn));
            pairs
                .into_iter()
                .all(|(a, b)| self.unshifted(a, b, units) <= SAME)
        };
        self.section == other.section
            && count == other.points.len()
            && (periods[0] - periods[1]).abs() <= SAME * periods[0].abs()
            && (0..count.max(1)).any(near)
    }

    /// How far a state is from a point, but for whole shifts.
    pub(super) fn unshifted(&self, state: &[f64], point: &[f64], units: &[f64]) -> f64 {
        match &self.shift {
            Some(shift) if self.slides => apart(&slid(state, point, shift), point, units),
            Some(shift) => apart(&unshifted(state, point, shift), point, units),
            None => apart(state, point, units),
        }
    }
}

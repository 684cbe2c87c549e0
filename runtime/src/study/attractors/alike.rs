//! Whether two computations have found the same motion.

use super::record::{Attractor, Class};
use crate::motion::{apart, half_extents};
use crate::shooting::{Shifts, slid, unshifted};

/// Points of two computations of one motion agree to this share of its extent.
const SAME: f64 = 1e-5;
/// Bounds and means of one irregular motion, known from different starts, agree to this share of its extent.
const ALIKE: f64 = 0.1;

impl Attractor {
    /// Half its extent, state by state; `fallback` where it has none.
    pub(super) fn magnitude(&self, fallback: &[f64]) -> Vec<f64> {
        half_extents(&self.min, &self.max, fallback)
    }

    /// Whether two computations have found the same motion, but for shifts that change nothing; states that hardly move are
    /// measured against `usual` sizes.
    pub(super) fn is(&self, other: &Self, usual: &[f64], shifts: &Shifts) -> bool {
        if self.class != other.class {
            return false;
        }
        let units = self.magnitude(usual);
        match self.class {
            Class::Equilibrium => shifts.apart(&other.state, &self.state, usual) <= SAME,
            Class::Sticking => self.modes == other.modes,
            Class::Orbit => self.coincides(other, &units, shifts),
            Class::Running => self.runs_like(other, usual) && self.coincides(other, &units, shifts),
            Class::Torus | Class::Chaos => self.extends_like(other, &units, shifts),
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

    /// Whether both keep to one region.
    fn extends_like(&self, other: &Self, units: &[f64], shifts: &Shifts) -> bool {
        let shift = shifts.between(&self.state, &other.state);
        let far = |here: &[f64], there: &[f64]| {
            let there = there.iter().zip(&shift).map(|(y, by)| y - by);
            apart(here, &there.collect::<Vec<f64>>(), units)
        };
        far(&self.state, &other.state)
            .max(far(&self.min, &other.min))
            .max(far(&self.max, &other.max))
            <= ALIKE
    }

    /// Whether both advance as much.
    fn runs_like(&self, other: &Self, usual: &[f64]) -> bool {
        match (&self.shift, &other.shift) {
            (Some(a), Some(b)) => apart(a, b, usual) <= SAME,
            _ => false,
        }
    }

    /// Whether both meet their section in the same points, in turn.
    fn coincides(&self, other: &Self, units: &[f64], shifts: &Shifts) -> bool {
        let count = self.points.len();
        let periods = [self, other].map(|one| one.period.unwrap_or(0.0));
        let near = |turn: usize| {
            let pairs = self
                .points
                .iter()
                .zip(other.points.iter().cycle().skip(turn));
            pairs
                .into_iter()
                .all(|(a, b)| self.unshifted(a, b, units, shifts) <= SAME)
        };
        self.section == other.section
            && count == other.points.len()
            && (periods[0] - periods[1]).abs() <= SAME * periods[0].abs()
            && (0..count.max(1)).any(near)
    }

    /// How far a state is from a point, but for what it gains in laps and for shifts that change nothing.
    pub(super) fn unshifted(
        &self,
        state: &[f64],
        point: &[f64],
        units: &[f64],
        shifts: &Shifts,
    ) -> f64 {
        match &self.shift {
            Some(shift) if self.slides => shifts.apart(&slid(state, point, shift), point, units),
            Some(shift) => shifts.apart(&unshifted(state, point, shift), point, units),
            None => shifts.apart(state, point, units),
        }
    }
}

//! Which symmetry an orbit has, and whether it loses one at a branch point.

use std::f64::consts::PI;

use nalgebra::DMatrix;

use super::involution::Symmetry;
use super::turns::Turns;
use crate::flow::{FlowError, Want};
use crate::linear::eigenvalues;
use crate::motion::{Family, Flow};
use crate::shooting::orbit::Orbit;

/// States at which a symmetry of the field is tried.
const TRIALS: usize = 6;
/// And how far from the middle of the orbit they lie, in its half extents.
const BEYOND: f64 = 1.2;
/// A field is symmetric to this share of its largest component.
const ROUNDING: f64 = 1e-11;
/// An orbit is symmetric to this share of its extents where one direction of it is critical: along that it is known to the
/// root of what the rest is, or lies beside the point itself on the branch that has lost the symmetry.
const CLOSE: f64 = 1e-2;
/// And to this one for sure: one beside a branch point where it is lost differs by more.
pub(in crate::shooting) const SURE: f64 = 1e-7;
/// And about, where errors grow along that: one that has lost it differs by more this near to where it is lost.
pub(super) const NEARLY: f64 = 1e-5;

impl Orbit {
    /// The symmetry of this orbit that the branch has lost which crosses its own at a branch point, if it has lost one: the
    /// direction in which it leaves changes sign where the orbit maps to itself. And whether that is half a period later.
    ///
    /// Looked for are symmetries of order two: changes of sign, exchanges of states (up to six of them), and half a
    /// turn of a drive or of what runs on; each leaves the orbit as it is at once, or after half its period.
    ///
    /// # Errors
    /// The flow fails on the orbit.
    pub(in crate::shooting) fn lost_symmetry(
        &self,
        family: &Family,
    ) -> Result<Option<(Symmetry, bool)>, FlowError> {
        let flow = family.at(self.r)?;
        let turns = self.turns(flow.as_ref());
        let candidates = self.symmetries(flow.as_ref(), Symmetry::all(&turns));
        if candidates.is_empty() {
            return Ok(None);
        }
        let after = |time: f64| flow.advance(&self.place, time, Want::DERIVATIVES);
        let (half, whole) = (after(0.5 * self.period)?, after(self.period)?);
        let ends = (self.place.state.as_slice(), Some(half.end.state.as_slice()));
        let loses = |(one, halfway): &(Symmetry, bool)| {
            let (along, fixed) = match halfway {
                true => (&half.derivatives, -1.0),
                false => (&whole.derivatives, 1.0),
            };
            let map = along.as_ref().map(|along| &along.state);
            map.is_some_and(|map| changes_sign(one, map, fixed))
        };
        let mut own = self
            .those_that_keep(candidates, ends, &turns, CLOSE)
            .into_iter();
        Ok(own.find(loses))
    }

    /// Those of the candidates that leave the orbit as it is to this share of its extents, at its start or after half its period,
    /// where it is then, if that is known; each with whether it is that.
    fn those_that_keep(
        &self,
        candidates: Vec<Symmetry>,
        (start, half): (&[f64], Option<&[f64]>),
        turns: &Turns,
        share: f64,
    ) -> Vec<(Symmetry, bool)> {
        let halfway = |one: &Symmetry| {
            let image = one.of(start);
            let is = |state: &[f64]| self.are_one(&image, state, turns, share);
            match is(start) {
                true => Some(false),
                false => half.filter(|half| is(half)).map(|_| true),
            }
        };
        let own = candidates.into_iter();
        own.filter_map(|one| halfway(&one).map(|halfway| (one, halfway)))
            .collect()
    }

    /// The symmetries that it has, each with whether that is so after half its period.
    pub(super) fn own_symmetries(&self, flow: &dyn Flow) -> Vec<(Symmetry, bool)> {
        let begin = self.begins();
        let half = flow.advance(begin, 0.5 * self.period, Want::default());
        let (half, turns) = (half.map(|half| half.end.state), self.turns(flow));
        let ends = (begin.state.as_slice(), half.as_deref().ok());
        let candidates = Symmetry::all(&turns);
        let mut own = self.those_that_keep(candidates, ends, &turns, SURE);
        for state in self.around() {
            own.retain(|(one, _)| commutes(flow, one, &state));
        }
        own
    }

    /// The symmetry that it has after half its period, if it has one.
    pub(in crate::shooting) fn mirrored(&self, flow: &dyn Flow) -> Option<Symmetry> {
        let mut own = self.own_symmetries(flow).into_iter();
        own.find_map(|(symmetry, halfway)| halfway.then_some(symmetry))
    }

    /// Whether it has lost the symmetry that an orbit before it has after half its period, by more than these errors.
    pub(in crate::shooting) fn has_lost(
        &self,
        family: &Family,
        before: &Self,
        errors: f64,
    ) -> bool {
        if !self.pins.is_empty() || !before.pins.is_empty() {
            // What is held may be held anywhere.
            return false;
        }
        let flow = family.at(before.r).ok();
        let Some(symmetry) = flow.and_then(|flow| before.mirrored(flow.as_ref())) else {
            return false;
        };
        let halves = (symmetry, true);
        self.keeps(family, &halves, errors) == Some(false)
            && self.image_returns(family, &halves.0, errors) == Some(true)
    }

    /// Whether its image is an orbit as well: where a wall that it meets stands on one side only, it is none, and the field has a
    /// symmetry only as far as orbits do not meet that. `None` if it cannot be gone around.
    fn image_returns(&self, family: &Family, symmetry: &Symmetry, errors: f64) -> Option<bool> {
        let flow = family.at(self.r).ok()?;
        let image = flow.place(&symmetry.of(&self.begins().state)).ok()?;
        let back = flow.advance(&image, self.period, Want::default()).ok()?;
        let turns = self.turns(flow.as_ref());
        Some(self.are_one(&image.state, &back.end.state, &turns, errors))
    }

    /// Whether this symmetry leaves it as it is but for these errors, at once or after half its period; `None` if it cannot be gone
    /// around.
    pub(in crate::shooting) fn keeps(
        &self,
        family: &Family,
        (symmetry, halfway): &(Symmetry, bool),
        errors: f64,
    ) -> Option<bool> {
        let flow = family.at(self.r).ok()?;
        let begin = self.begins();
        let time = if *halfway { 0.5 * self.period } else { 0.0 };
        let met = flow.advance(begin, time, Want::default()).ok()?.end.state;
        let turns = self.turns(flow.as_ref());
        Some(self.are_one(&symmetry.of(&begin.state), &met, &turns, errors))
    }

    /// Those of the candidates that are symmetries of the field.
    fn symmetries(&self, flow: &dyn Flow, mut candidates: Vec<Symmetry>) -> Vec<Symmetry> {
        for state in self.around() {
            candidates.retain(|one| commutes(flow, one, &state));
        }
        candidates
    }

    /// States in the box of the orbit, and a little beyond.
    fn around(&self) -> impl Iterator<Item = Vec<f64>> {
        let magnitude = self.magnitude();
        // Multiples of irrational numbers, apart from their whole parts: spread evenly, and the same every time.
        (1..=TRIALS).map(move |trial| {
            let component = |j: usize| {
                let share = (trial as f64 * (PI + j as f64).sqrt()).fract();
                let middle = 0.5 * (self.min[j] + self.max[j]);
                middle + BEYOND * magnitude[j] * (2.0 * share - 1.0)
            };
            (0..magnitude.len()).map(component).collect()
        })
    }

    /// What of its states comes round.
    pub(super) fn turns(&self, flow: &dyn Flow) -> Turns {
        Turns::of(flow.order(), flow.phase(), self.shift.as_deref())
    }

    /// Whether two states are one, to this share of the orbit's extents.
    fn are_one(&self, p: &[f64], q: &[f64], turns: &Turns, share: f64) -> bool {
        let magnitude = self.magnitude();
        (0..p.len()).all(|j| turns.rest(j, p[j] - q[j]).abs() <= share * magnitude[j])
    }
}

/// Whether the field at the image of a state is the image of the field.
fn commutes(flow: &dyn Flow, one: &Symmetry, state: &[f64]) -> bool {
    let field = |state: &[f64]| -> Option<Vec<f64>> {
        let place = flow.place(state).ok()?;
        Some(flow.velocity(&place).ok()?.f.as_slice().to_vec())
    };
    let (Some(here), Some(there)) = (field(state), field(&one.of(state))) else {
        return false;
    };
    let image = one.linear(&here);
    let size = here.iter().fold(0.0_f64, |most, f| most.max(f.abs()));
    (0..image.len()).all(|j| (image[j] - there[j]).abs() <= ROUNDING * size)
}

/// Whether the critical direction of an orbit changes sign under its symmetry S.
///
/// An orbit that S leaves as it is: Φ is split by (1 ± S)/2, and its second multiplier 1 belongs to one of the parts.
/// One that S leaves as it is after half a period: SΦ(T/2) has the squares roots of the multipliers, that of the flow's
/// own being 1, and a critical one is 1 or −1.
fn changes_sign(symmetry: &Symmetry, map: &DMatrix<f64>, fixed: f64) -> bool {
    let [kept, changed] = if fixed > 0.0 {
        [1.0, -1.0].map(|sign| symmetry.part(sign) * map)
    } else {
        [symmetry.matrix() * map, symmetry.matrix() * map]
    };
    let mut kept = distances(&kept, 1.0);
    kept.sort_by(f64::total_cmp);
    let changed = distances(&changed, fixed);
    let critical = changed.into_iter().fold(f64::INFINITY, f64::min);
    // The first is the flow's own direction.
    critical < kept.get(1).copied().unwrap_or(f64::INFINITY)
}

/// How far each eigenvalue is from a number.
fn distances(matrix: &DMatrix<f64>, from: f64) -> Vec<f64> {
    let all = eigenvalues(matrix).into_iter();
    all.map(|one| (one.value - from).norm()).collect()
}

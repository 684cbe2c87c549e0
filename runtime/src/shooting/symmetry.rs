//! Which symmetry an orbit has, and whether it loses one at a branch point.

use std::f64::consts::{PI, TAU};

use nalgebra::DMatrix;

use super::orbit::Orbit;
use crate::flow::{FlowError, Want};
use crate::linear::eigenvalues;
use crate::motion::{Family, Flow};

/// Systems of more states are asked for changes of sign only: exchanges of states become too many.
const EXCHANGED: usize = 6;
/// Systems of more states are asked for the change of all signs only.
const SIGNED: usize = 12;
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
pub(super) const SURE: f64 = 1e-7;

/// A symmetry of order two: states change signs and places in pairs, and the phase of a drive moves by half a turn.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Symmetry {
    /// Which state each one becomes.
    place: Vec<usize>,
    /// And with which sign.
    sign: Vec<f64>,
    /// The state that is the phase of a drive, if it moves.
    phase: Option<usize>,
}

impl Symmetry {
    /// What it makes of a direction.
    fn linear(&self, y: &[f64]) -> Vec<f64> {
        let pairs = self.sign.iter().zip(&self.place);
        pairs.map(|(sign, place)| sign * y[*place]).collect()
    }

    /// What it makes of a state.
    pub(super) fn of(&self, y: &[f64]) -> Vec<f64> {
        let mut image = self.linear(y);
        if let Some(phase) = self.phase {
            image[phase] += PI;
        }
        image
    }

    /// What it makes of directions.
    pub(super) fn matrix(&self) -> DMatrix<f64> {
        let order = self.sign.len();
        DMatrix::from_fn(order, order, |i, j| {
            if j == self.place[i] {
                self.sign[i]
            } else {
                0.0
            }
        })
    }

    /// All of them but the one that changes nothing.
    fn all(order: usize, drive: Option<usize>) -> Vec<Self> {
        let mut all = vec![Self::signed(vec![0.0; order])];
        if order > SIGNED {
            let sign = |i| if Some(i) == drive { 1.0 } else { -1.0 };
            all[0].sign = (0..order).map(sign).collect();
        } else {
            for i in 0..order {
                all = all
                    .iter()
                    .flat_map(|one| one.extended(i, Some(i) == drive))
                    .collect();
            }
        }
        let nothing = Self::signed(vec![1.0; order]);
        let phases = [None, drive];
        let moved = all.iter().flat_map(|one| {
            phases.map(|phase| Self {
                phase,
                ..one.clone()
            })
        });
        let mut moved: Vec<Self> = moved
            .filter(|one| one.phase.is_some() || *one != nothing)
            .collect();
        moved.dedup();
        moved
    }

    /// Changes these signs and no places.
    fn signed(sign: Vec<f64>) -> Self {
        Self {
            place: (0..sign.len()).collect(),
            sign,
            phase: None,
        }
    }

    /// The ways in which state i can take part, if those before it are settled.
    fn extended(&self, i: usize, is_drive: bool) -> Vec<Self> {
        if self.sign[i] != 0.0 {
            return vec![self.clone()];
        }
        let partners = if is_drive || self.sign.len() > EXCHANGED {
            i..i + 1
        } else {
            i..self.sign.len()
        };
        let signs: &[f64] = if is_drive { &[1.0] } else { &[1.0, -1.0] };
        let pairs = partners.flat_map(|j| signs.iter().map(move |sign| (j, *sign)));
        pairs
            .filter(|(j, _)| self.sign[*j] == 0.0)
            .map(|(j, sign)| {
                let mut one = self.clone();
                (one.place[i], one.place[j]) = (j, i);
                (one.sign[i], one.sign[j]) = (sign, sign);
                one
            })
            .collect()
    }
}

impl Orbit {
    /// The symmetry of this orbit that the branch has lost which crosses its own at a branch point, if it has lost one: the
    /// direction in which it leaves changes sign where the orbit maps to itself. And whether that is half a period later.
    ///
    /// Looked for are symmetries of order two: changes of sign, exchanges of states (up to six of them), and half a
    /// turn of a drive; each leaves the orbit as it is at once, or after half its period.
    ///
    /// # Errors
    /// The flow fails on the orbit.
    pub(super) fn lost_symmetry(
        &self,
        family: &Family,
    ) -> Result<Option<(Symmetry, bool)>, FlowError> {
        let flow = family.at(self.r)?;
        let drive = flow.phase();
        let candidates = self.symmetries(flow.as_ref(), Symmetry::all(flow.order(), drive));
        if candidates.is_empty() {
            return Ok(None);
        }
        let after = |time: f64| flow.advance(&self.place, time, Want::DERIVATIVES);
        let (half, whole) = (after(0.5 * self.period)?, after(self.period)?);
        let start = &self.place.state;
        for one in candidates {
            let image = one.of(start);
            let (map, fixed) = if self.are_one(&image, start, drive, CLOSE) {
                (&whole.derivatives, 1.0)
            } else if self.are_one(&image, &half.end.state, drive, CLOSE) {
                (&half.derivatives, -1.0)
            } else {
                continue;
            };
            let Some(map) = map else { continue };
            if changes_sign(&one.matrix(), &map.state, fixed) {
                return Ok(Some((one, fixed < 0.0)));
            }
        }
        Ok(None)
    }

    /// The symmetry that the orbit has after half its period, if it has one.
    pub(super) fn mirrored(&self, flow: &dyn Flow) -> Option<Symmetry> {
        let begin = self.begins();
        let half = flow.advance(begin, 0.5 * self.period, Want::default());
        let (half, drive) = (half.ok()?.end.state, flow.phase());
        let mut candidates = Symmetry::all(flow.order(), drive);
        candidates.retain(|one| self.are_one(&one.of(&begin.state), &half, drive, SURE));
        self.symmetries(flow, candidates).into_iter().next()
    }

    /// Whether it has lost the symmetry that an orbit before it has after half its period, by more than these errors.
    pub(super) fn has_lost(&self, family: &Family, before: &Self, errors: f64) -> bool {
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
        Some(self.are_one(&image.state, &back.end.state, flow.phase(), errors))
    }

    /// Whether this symmetry leaves it as it is but for these errors, at once or after half its period; `None` if it cannot be gone
    /// around.
    pub(super) fn keeps(
        &self,
        family: &Family,
        (symmetry, halfway): &(Symmetry, bool),
        errors: f64,
    ) -> Option<bool> {
        let flow = family.at(self.r).ok()?;
        let begin = self.begins();
        let time = if *halfway { 0.5 * self.period } else { 0.0 };
        let met = flow.advance(begin, time, Want::default()).ok()?.end.state;
        Some(self.are_one(&symmetry.of(&begin.state), &met, flow.phase(), errors))
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

    /// Whether two states are one, to this share of the orbit's extents.
    fn are_one(&self, p: &[f64], q: &[f64], drive: Option<usize>, share: f64) -> bool {
        let magnitude = self.magnitude();
        (0..p.len()).all(|j| {
            let mut apart = p[j] - q[j];
            if drive == Some(j) {
                apart -= TAU * (apart / TAU).round();
            }
            apart.abs() <= share * magnitude[j]
        })
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
fn changes_sign(symmetry: &DMatrix<f64>, map: &DMatrix<f64>, fixed: f64) -> bool {
    let identity = DMatrix::<f64>::identity(symmetry.nrows(), symmetry.nrows());
    let part = |sign: f64| (&identity + symmetry * sign) * 0.5 * map;
    let [kept, changed] = if fixed > 0.0 {
        [part(1.0), part(-1.0)]
    } else {
        [symmetry * map, symmetry * map]
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

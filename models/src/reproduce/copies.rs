//! Smooth copies of one system beside its exact friction: an orbit of each, and its branches.

use stickslip::bifurcation::Stability;
use stickslip::field::{Kernel, Smoothing};
use stickslip::report::chart::placed;
use stickslip::report::numerals::power;
use stickslip::report::{Coordinate, Curve, traced};
use stickslip::study::{Dynamics, OrbitRecord, parallel};

use super::ReproduceError;
use super::ask::{Cycle, Subject};
use super::branch::Branch;
use super::pieces::{UNKNOWN, directed};

/// A system with one friction.
pub(super) struct Member {
    pub(super) label: String,
    pub(super) cycle: Cycle,
    /// Its branches from there, one to each end.
    pub(super) branches: Vec<Branch>,
}

/// Copies of a system, and the system itself.
pub(super) struct Copies {
    /// The copies with the exponents of their sizes.
    pub(super) copies: Vec<(i32, Member)>,
    pub(super) exact: Member,
}

/// The copy of size 10ⁱ.
pub(super) fn copy(kernel: Kernel, exponent: i32) -> Dynamics {
    let size = 10f64.powi(exponent);
    Dynamics::Smoothed(Smoothing { kernel, size })
}

impl Member {
    /// The orbit where the parameter is `from`, and its branches to each of `ends`.
    pub(super) fn find(
        subject: &Subject,
        dynamics: Dynamics,
        (from, ends): (f64, &[f64]),
        label: String,
    ) -> Result<Self, ReproduceError> {
        let branches = ends.iter().map(|&to| subject.branch(dynamics, from, to));
        Ok(Self {
            label,
            cycle: subject.cycle(dynamics, from)?,
            branches: branches.collect::<Result<_, _>>()?,
        })
    }

    /// The orbits of all branches in the order along them.
    pub(super) fn points(&self) -> Vec<&OrbitRecord> {
        let mut points: Vec<&OrbitRecord> = Vec::new();
        for branch in &self.branches {
            points.reverse();
            // All branches begin with the same orbit.
            let shared = usize::from(!points.is_empty());
            points.extend(branch.points.iter().skip(shared));
        }
        points
    }

    /// A quantity of the orbits along the branches, in the style of series number `series`.
    pub(super) fn along(&self, label: &str, series: usize, of: fn(&OrbitRecord) -> f64) -> Curve {
        let points = self.points().into_iter();
        let placed = points.map(|orbit| placed(orbit, |orbit| Some(of(orbit))));
        let points = placed.map(|(at, direction)| (at, direction.unwrap_or(UNKNOWN)));
        directed(label, series, points.collect())
    }

    /// The orbit at the beginning, in the plane of the first two states.
    pub(super) fn plane(&self, label: &str, series: usize) -> Curve {
        traced(
            label,
            series,
            &self.cycle.motion,
            [0, 1].map(Coordinate::State),
        )
    }

    /// What the branches along `name` cost.
    pub(super) fn costs(&self, name: &str, thesis: &str) -> Vec<Vec<String>> {
        let branches = self.branches.iter();
        branches.map(|branch| branch.cost(name, thesis)).collect()
    }
}

impl Copies {
    /// The copies of these sizes 10ⁱ and the exact system: where the parameter is `from`, and on the way to each of `ends`.
    pub(super) fn find(
        subject: &Subject,
        (kernel, exponents, unit): (Kernel, &[i32], &str),
        ends: (f64, &[f64]),
    ) -> Result<Self, ReproduceError> {
        let one = |&exponent: &i32| {
            let label = format!("*ε* = {}{unit}", power(exponent));
            let found = Member::find(subject, copy(kernel, exponent), ends, label);
            Ok((exponent, found?))
        };
        let copies = parallel(exponents, one).into_iter();
        Ok(Self {
            copies: copies.collect::<Result<_, ReproduceError>>()?,
            exact: Member::find(subject, Dynamics::Exact, ends, "exact".to_owned())?,
        })
    }

    /// What all branches cost along the parameter with this symbol.
    pub(super) fn costs(&self, system: &str, symbol: &str, thesis: &str) -> Vec<Vec<String>> {
        let costs =
            |one: &Member, thesis| one.costs(&format!("{system}, {}, {symbol}", one.label), thesis);
        let copies = self.copies.iter().flat_map(|(_, copy)| costs(copy, thesis));
        copies.chain(costs(&self.exact, "–")).collect()
    }

    /// The orbits of all branches of the copies.
    pub(super) fn points(&self) -> impl Iterator<Item = &OrbitRecord> {
        self.copies.iter().flat_map(|(_, copy)| copy.points())
    }

    /// A curve for each copy, and one for the exact system: behind the copies, which it would hide.
    fn curves(&self, draw: impl Fn(&Member, usize) -> Curve) -> Vec<Curve> {
        let copies = (1..).zip(self.copies.iter().map(|(_, copy)| copy));
        let all = [(0, &self.exact)].into_iter().chain(copies);
        all.map(|(series, one)| draw(one, series)).collect()
    }

    fn along(&self, of: fn(&OrbitRecord) -> f64) -> Vec<Curve> {
        self.curves(|one, series| one.along(&one.label, series, of))
    }

    /// The orbits at the beginning, in the plane of the first two states.
    pub(super) fn planes(&self) -> Vec<Curve> {
        self.curves(|one, series| one.plane(&one.label, series))
    }

    /// The largest magnitude of the first state along the branches.
    pub(super) fn amplitudes(&self) -> Vec<Curve> {
        self.along(|orbit| orbit.max_abs[0])
    }

    /// The frequency along the branches.
    pub(super) fn frequencies(&self) -> Vec<Curve> {
        self.along(|orbit| 1.0 / orbit.period)
    }
}

/// How many orbits are stable, and what the others are.
pub(super) fn stability<'a>(orbits: impl IntoIterator<Item = &'a OrbitRecord>) -> String {
    let orbits = orbits.into_iter();
    let all: Vec<Stability> = orbits.map(|orbit| orbit.floquet.stability).collect();
    let of = |kind| all.iter().filter(|stability| **stability == kind).count();
    let stable = of(Stability::Stable);
    if stable == all.len() {
        return format!("all {stable} orbits stable");
    }
    let others = [
        (of(Stability::Undecided), "undecided"),
        (of(Stability::Unstable), "unstable"),
    ];
    let others = others.iter().filter(|(number, _)| *number > 0);
    others.fold(format!("{stable} stable"), |text, (number, word)| {
        format!("{text}, {number} {word}")
    })
}

//! Equilibria at one value of the design variable: Newton, damped, from many places.

use nalgebra::DVector;

use super::sizes::{largest, sizes_at};
use super::starts::around;
use super::unread::unread;
use super::{EquilibriumProblem, Spectrum};
use crate::continuation::{Linearisation, ZeroProblem, damped};
use crate::motion::{Family, Modes, Place};

const ITERATIONS: usize = 100;
/// Newton's step is halved at most down to this share.
const LEAST_DAMPING: f64 = 1.0 / 1024.0;
/// Corrections below this share of the states are rounding error.
const CONVERGED: f64 = 1e-13;
/// A correction that no longer shrinks has converged if it is below this.
const STALLED: f64 = 1e-9;
/// Two equilibria closer than this are one, in units of what their states usually are.
const SAME_STATE: f64 = 1e-7;
/// How often Newton begins anew where states turn out to be of other sizes than where it began.
const ROUNDS: usize = 8;
/// A state of this share of where it began, or of 1 where that is more, is zero.
const ZERO: f64 = 1e-20;

/// An equilibrium.
#[derive(Debug, Clone, PartialEq)]
pub struct Equilibrium {
    /// Where, and in which modes.
    pub place: Place,
    /// Its eigenvalues.
    pub spectrum: Spectrum,
}

/// Every equilibrium at r that Newton reaches from one of `starts` in one of `modes`, each once, and only those
/// whose contacts slide as the mode says. `modes` gives the modes worth trying from a start.
pub fn find(
    family: &Family,
    r: f64,
    starts: &[Vec<f64>],
    modes: impl Fn(&[f64]) -> Vec<Modes>,
) -> Vec<Equilibrium> {
    let mut found = Vec::new();
    add(&mut found, (family, r), starts, &modes);
    found
}

/// The same, and then from places around those that are found, as far as these show how large states are.
pub fn find_around(
    family: &Family,
    r: f64,
    starts: &[Vec<f64>],
    modes: impl Fn(&[f64]) -> Vec<Modes>,
) -> Vec<Equilibrium> {
    let mut found = find(family, r, starts, &modes);
    if !found.is_empty() {
        let first = starts.first().map(|y| y.iter().map(|y| y.abs()).collect());
        let sizes = found.iter().map(|one| sizes_at(family, r, &one.place));
        let around = around(&largest(sizes.chain(first)));
        add(&mut found, (family, r), &around, &modes);
    }
    found
}

/// Adds those that are reached from these starts and are none of those before.
fn add(
    found: &mut Vec<Equilibrium>,
    (family, r): (&Family, f64),
    starts: &[Vec<f64>],
    modes: &impl Fn(&[f64]) -> Vec<Modes>,
) {
    for start in starts {
        for modes in modes(start) {
            let state = start.clone();
            if let Some(new) = settle(family, r, &Place { state, modes })
                && !found
                    .iter()
                    .any(|old| same(family, r, [&old.place, &new.place]))
            {
                found.push(new);
            }
        }
    }
}

/// The equilibrium that Newton reaches from a place, staying in its mode; `None` if there is none, or if its
/// contacts do not slide as the mode says.
#[must_use]
pub fn settle(family: &Family, r: f64, from: &Place) -> Option<Equilibrium> {
    let found = rests(family, r, from)?;
    let margins = family.at(r).ok()?.margins(&found.place);
    let inside = margins.iter().all(|(_, margin)| *margin > 0.0);
    inside.then_some(found)
}

/// The same whatever its contacts do there: what slides may linger where the equations of sliding rest, though it would stick
/// there.
pub(crate) fn rests(family: &Family, r: f64, from: &Place) -> Option<Equilibrium> {
    let (place, problem) = rested(family, r, from)?;
    let flow = family.at(r).ok()?;
    flow.check(&place).ok()?;
    let velocity = flow.velocity(&place).ok()?;
    if !problem.rests(&velocity, STALLED) {
        return None;
    }
    let spectrum = problem.spectrum(Some(flow.as_ref()), &place, &velocity);
    Some(Equilibrium { place, spectrum })
}

/// Where Newton comes to rest: found anew from there, in the sizes that states have there, until it stays.
fn rested(family: &Family, r: f64, from: &Place) -> Option<(Place, EquilibriumProblem)> {
    let mut place = from.clone();
    let mut problem = EquilibriumProblem::new(family.clone(), r, &place);
    for _ in 0..ROUNDS {
        let z = newton(&mut problem, DVector::from_column_slice(&place.state), r)?;
        let before = std::mem::replace(&mut place, problem.place(&z)).state;
        for (y, began) in place.state.iter_mut().zip(&from.state) {
            if y.abs() <= ZERO * began.abs().max(1.0) {
                *y = 0.0;
            }
        }
        let next = EquilibriumProblem::new(family.clone(), r, &place);
        if near(&place.state, &before, next.magnitude()) {
            return Some((place, problem));
        }
        problem = next;
    }
    None
}

/// Whether two are one; which way a contact slides tells them apart only where it matters.
fn same(family: &Family, r: f64, [a, b]: [&Place; 2]) -> bool {
    let alike = || {
        let margins = family.at(r).map(|flow| flow.margins(a));
        let matters = |i: usize| margins.iter().flatten().any(|(one, _)| *one == i);
        let mut pairs = a.modes.iter().zip(&b.modes).enumerate();
        pairs.all(|(i, (a, b))| {
            a == b || (a.rubs() && b.rubs() && !a.binds() && !b.binds() && !matters(i))
        })
    };
    let [own, others] = [a, b].map(|place| sizes_at(family, r, place));
    let mut sizes: Vec<f64> = own.iter().zip(&others).map(|(a, b)| a.min(*b)).collect();
    for j in unread(family, r, a, &own) {
        sizes[j] = f64::INFINITY;
    }
    near(&a.state, &b.state, &sizes) && (a.modes == b.modes || alike())
}

/// Whether two equilibria of one mode are one, as far as numbers can tell, where states are of these sizes.
pub(super) fn near(a: &[f64], b: &[f64], sizes: &[f64]) -> bool {
    a.iter().zip(b).zip(sizes).all(|((a, b), size)| {
        let size = a.abs().max(b.abs()).max(*size);
        (a - b).abs() <= SAME_STATE * size
    })
}

/// The solution to which damped steps lead; `None` where they lead to none.
fn newton<P: ZeroProblem>(problem: &mut P, mut z: DVector<f64>, r: f64) -> Option<DVector<f64>> {
    let mut before = f64::INFINITY;
    let scale = problem.scale();
    let size = |step: &DVector<f64>, z: &DVector<f64>| {
        let relative = |j: usize| step[j] / z[j].abs().max(scale[j]);
        (0..step.len())
            .map(|j| relative(j).powi(2))
            .sum::<f64>()
            .sqrt()
    };
    let mut here = problem.evaluate(&z, r).ok()?;
    for _ in 0..ITERATIONS {
        let factors = here.jacobian.lu();
        let step = factors.solve(&-&here.residual)?;
        let length = size(&step, &z);
        if !length.is_finite() {
            return None;
        }
        if length <= CONVERGED || (length <= STALLED && length > 0.5 * before) {
            return Some(z + step);
        }
        before = length;
        let left = |there: &Linearisation<P::Extra>| {
            let next = factors.solve(&there.residual)?;
            Some(size(&next, &z))
        };
        let most = |share: f64| match length <= STALLED {
            true => f64::INFINITY,
            false => (1.0 - 0.25 * share) * length,
        };
        let shares = (1.0, LEAST_DAMPING);
        let went = damped(problem, r, (&z, &step), shares, left, most)?;
        (z, here) = (went.z, went.at);
    }
    None
}

//! Where a branch of orbits sets out.

use nalgebra::DVector;

use super::anchor::problem;
use super::orbit::Orbit;
use super::problem::OrbitProblem;
use super::sought::Search;
use crate::continuation::{Branch, Failure, Settings, Started, Watched};
use crate::flow::FlowError;
use crate::integrate::Tolerance;
use crate::motion::Family;

/// Share of the accuracy to which orbits are integrated where more digits count: between two others, and where errors grow.
pub(super) const SHARPER: f64 = 0.02;

/// Shares of the range after which a branch begins that would set out where branches meet.
const ASIDE: [f64; 2] = [1e-4, 1e-3];

/// The branch through an orbit found at r, anywhere in the range of the settings, that goes up from there or down.
///
/// Where branches meet, its equations are singular: it begins next to there.
///
/// # Errors
/// The orbit cannot be converged on with the family's derivative ∂/∂r.
pub(super) fn begin(
    family: &Family,
    orbit: &Orbit,
    search: &Search,
    settings: Settings,
    (r, upwards): (f64, bool),
) -> Result<Started<OrbitProblem>, Failure<FlowError>> {
    let end = match upwards {
        true => settings.from.max(settings.to),
        false => settings.from.min(settings.to),
    };
    let at = |share: f64, aside: f64| {
        let family = family.with_tolerance(Tolerance::for_accuracy(share * search.accuracy));
        let r = r + aside * (end - r);
        through(&family, orbit, search, settings, (r, upwards))
    };
    let started = match at(1.0, 0.0) {
        // Errors of the integration may be what keeps Newton's method from the orbit that it has found before.
        Err(Failure::ResidualRose { .. } | Failure::NoConvergence { .. }) => at(SHARPER, 0.0),
        started => started,
    };
    started.or_else(|failure| {
        let aside = |share: &f64| at(1.0, *share).ok();
        let next_to = match orbit.marginal() {
            Some(0) => None,
            _ => ASIDE.iter().find_map(aside),
        };
        next_to.ok_or(failure)
    })
}

/// The same with the tolerance of this family.
fn through(
    family: &Family,
    orbit: &Orbit,
    search: &Search,
    settings: Settings,
    (r, upwards): (f64, bool),
) -> Result<Started<OrbitProblem>, Failure<FlowError>> {
    let guess = orbit.guess();
    let family = family.with_magnitude(&guess.magnitude);
    let (mut problem, z) =
        problem(family, r, &guess, search.segments).map_err(Failure::Evaluation)?;
    problem.accuracy = search.accuracy;
    let flow = problem.family.at(r).map_err(Failure::Evaluation)?;
    problem.may_run(flow.as_ref());
    problem.centre(r).map_err(Failure::Evaluation)?;
    let plain = problem.clone();
    problem.balance(&orbit.segments, (&z, r));
    let balanced = problem.pins != plain.pins;
    let set_out = |mut problem: OrbitProblem| {
        problem
            .float(&guess.place, r)
            .map_err(Failure::Evaluation)?;
        let mut direction = DVector::zeros(z.len() + 1);
        direction[z.len()] = if upwards { 1.0 } else { -1.0 };
        Branch::set_out(problem, (z.clone(), r), (&direction, 1.0), settings)
    };
    match set_out(problem) {
        // A middle that hardly tells the place, as that of a spring without a linear part, leaves it where it is.
        Err(_) if balanced => set_out(plain),
        started => started,
    }
}

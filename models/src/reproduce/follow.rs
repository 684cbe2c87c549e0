//! Orbits and branches with what they cost.

use std::time::{Duration, Instant};

use stickslip::bifurcation::Stability;
use stickslip::continuation::{Ending, Failure, Settings};
use stickslip::field::{Design, Kernel, SmoothField, Smoothing, Work};
use stickslip::flow::{Family, Flow, FlowError, Sample, SmoothFamily, Want};
use stickslip::integrate::Tolerance;
use stickslip::model::{Model, ParamId};
use stickslip::shooting::{
    Orbit, OrbitBranch, OrbitError, Search, Settled, closest, converge, settle,
};
use stickslip::study::trade::TradeError;

/// Relative accuracy that every orbit of the report is computed to.
pub(super) const ACCURACY: f64 = 1e-8;

/// A periodic orbit of a smooth copy, drawn.
pub(super) struct Drawn<const N: usize> {
    pub(super) orbit: Orbit<N, ()>,
    pub(super) path: Vec<Sample<N>>,
    pub(super) time: Duration,
}

/// A branch with what it cost.
pub(super) struct Followed<const N: usize> {
    pub(super) orbits: Vec<Orbit<N, ()>>,
    pub(super) end: End,
    pub(super) time: Duration,
    pub(super) work: Work,
}

/// Where a branch ends, and why.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum End {
    /// Where it was told to.
    Reached(f64),
    /// The cycle has shrunk to an equilibrium at this r.
    Vanishes(f64),
    /// The cycle meets an unstable one at this r and turns back with it.
    Folds(f64),
    /// Path following gave up at this r, for this reason.
    GaveUp(f64, String),
}

/// Why an orbit or a branch of the report is missing.
#[derive(Debug, thiserror::Error)]
pub enum FollowError {
    /// No orbit to begin with.
    #[error(transparent)]
    Orbit(#[from] OrbitError),
    /// The branch could not be started.
    #[error("the branch did not start: {0}")]
    Start(Failure<FlowError>),
    /// The orbit could not be drawn.
    #[error(transparent)]
    Flow(#[from] FlowError),
    /// Smooth copies could not be compared.
    #[error(transparent)]
    Trade(#[from] TradeError),
    /// There were none to compare.
    #[error("no smooth copies were compared")]
    NoCopies,
}

/// The smooth copies of `model` along one parameter.
pub(super) fn family<M: Model<N>, const N: usize>(
    model: M,
    along: ParamId<M>,
    smoothing: Option<(Kernel, f64)>,
) -> SmoothFamily<M, N> {
    SmoothFamily {
        model,
        smoothing: smoothing.map(|(kernel, size)| Smoothing { kernel, size }),
        design: Design::Parameter(along.index),
        tolerance: Tolerance::for_accuracy(ACCURACY),
        magnitude: [1.0; N],
    }
}

/// The field of one smooth copy, as an integrator sees it.
pub(super) fn field<M: Model<N>, const N: usize>(
    model: &M,
    kernel: Kernel,
    size: f64,
) -> Result<SmoothField<M, N>, FollowError> {
    let smoothing = Smoothing { kernel, size };
    SmoothField::new(model, Some(smoothing), Design::None)
        .map_err(|error| FlowError::Smoothing(error).into())
}

/// What to look for: from `start`, with a known period or by settling.
pub(super) fn search<const N: usize>(start: [f64; N], period: Option<f64>) -> Search<N> {
    Search {
        start,
        period,
        accuracy: ACCURACY,
        segments: 1,
    }
}

/// The orbit at r with one period of its motion.
pub(super) fn draw<M: Model<N>, const N: usize>(
    family: &SmoothFamily<M, N>,
    r: f64,
    search: &Search<N>,
) -> Result<Drawn<N>, FollowError> {
    let clock = Instant::now();
    let orbit = closest(family, r, search)?;
    drawn(family, orbit, clock.elapsed())
}

/// The stable orbit at r on which the motion from `start` settles, with one period of its motion.
pub(super) fn draw_stable<M: Model<N>, const N: usize>(
    family: &SmoothFamily<M, N>,
    r: f64,
    start: [f64; N],
) -> Result<Drawn<N>, FollowError> {
    let clock = Instant::now();
    let flow = family.at(r)?;
    let search = search(start, None);
    let settled = settle(&flow, flow.place(start)?, |guess| {
        // A motion passes close to unstable orbits on its way, and they answer to Newton as well.
        converge(family, r, guess, &search)
            .ok()
            .filter(|orbit| orbit.floquet.stability == Stability::Stable)
    })?;
    match settled {
        Settled::Orbit(orbit) => drawn(family, orbit, clock.elapsed()),
        Settled::Equilibrium(state) => Err(OrbitError::Equilibrium {
            state: state.to_vec(),
        }
        .into()),
        Settled::Neither(time) => Err(OrbitError::NotSettled { time }.into()),
    }
}

fn drawn<M: Model<N>, const N: usize>(
    family: &SmoothFamily<M, N>,
    orbit: Orbit<N, ()>,
    time: Duration,
) -> Result<Drawn<N>, FollowError> {
    let want = Want {
        path: true,
        ..Want::default()
    };
    let flow = family.at(orbit.r)?;
    let path = flow.advance(&orbit.place, orbit.period, want)?.path;
    Ok(Drawn { orbit, path, time })
}

/// The branch from `orbit` towards r = `to`, until its cycle vanishes or folds back.
pub(super) fn follow<M: Model<N>, const N: usize>(
    family: &SmoothFamily<M, N>,
    orbit: &Orbit<N, ()>,
    to: f64,
) -> Result<Followed<N>, FollowError> {
    let clock = Instant::now();
    let settings = Settings::new(orbit.r, to, ACCURACY);
    let search = search(orbit.place.state, Some(orbit.period));
    let mut branch =
        OrbitBranch::start(family, orbit, &search, settings).map_err(FollowError::Start)?;
    let mut orbits: Vec<Orbit<N, ()>> = Vec::new();
    let mut end = None;
    while end.is_none()
        && let Some(orbit) = branch.next()
    {
        orbits.push(orbit);
        end = vanishes(&orbits).or_else(|| folds(&mut orbits, to));
    }
    let last = orbits.last().map_or(orbit.r, |orbit| orbit.r);
    let end = end.unwrap_or_else(|| match branch.ending() {
        Some(Ending::StepTooSmall(failure)) => End::GaveUp(last, failure.to_string()),
        Some(Ending::TooManyPoints) => End::GaveUp(last, "too many points".to_owned()),
        _ => End::Reached(last),
    });
    let mut work = Work::default();
    orbits.iter().for_each(|orbit| work += orbit.work);
    Ok(Followed {
        orbits,
        end,
        time: clock.elapsed(),
        work,
    })
}

/// A cycle this small against the first one is about to vanish.
const SMALL: f64 = 1e-4;

/// Whether the cycle shrinks to an equilibrium, and where: the square of its extent is linear in r there.
fn vanishes<const N: usize>(orbits: &[Orbit<N, ()>]) -> Option<End> {
    let [first, .., before, last] = orbits else {
        return None;
    };
    let extent = |orbit: &Orbit<N, ()>| orbit.max[0] - orbit.min[0];
    if extent(last) > SMALL * extent(first) {
        return None;
    }
    let (a, b) = (extent(before).powi(2), extent(last).powi(2));
    Some(End::Vanishes(last.r - (last.r - before.r) * b / (b - a)))
}

/// Whether the branch has turned back; what lies beyond the fold is taken off.
fn folds<const N: usize>(orbits: &mut Vec<Orbit<N, ()>>, to: f64) -> Option<End> {
    let [.., before, last] = orbits.as_slice() else {
        return None;
    };
    let turned = (last.r - before.r) * (to - orbits[0].r) < 0.0;
    let fold = before.r;
    turned.then(|| {
        orbits.pop();
        End::Folds(fold)
    })
}

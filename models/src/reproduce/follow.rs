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
    /// Path following gave up at this r.
    GaveUp(f64),
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
        Settled::Neither(time) => Err(OrbitError::NotSettled { time, last: None }.into()),
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

/// Longer steps would do for the branch, but not for a smooth drawing of it.
const LARGEST_STEP: f64 = 0.08;
/// Segments of multiple shooting where simple shooting gives up.
const SEGMENTS: usize = 10;
/// Points that are given back before a branch is continued by multiple shooting.
const GIVEN_BACK: usize = 10;

/// The branch from `orbit` towards r = `to`, until its cycle vanishes or folds back.
///
/// Where the motion runs along an unstable part of the friction curve, simple shooting loses its
/// digits and gives up; multiple shooting takes over from there.
pub(super) fn follow<M: Model<N>, const N: usize>(
    family: &SmoothFamily<M, N>,
    orbit: &Orbit<N, ()>,
    to: f64,
) -> Result<Followed<N>, FollowError> {
    let clock = Instant::now();
    let mut branch = stretch(family, orbit, to, 1)?;
    if matches!(branch.end, End::GaveUp(..)) {
        let from = branch.orbits.len().saturating_sub(GIVEN_BACK);
        if let Ok(rest) = stretch(family, &branch.orbits[from], to, SEGMENTS)
            && (rest.orbits.len() > GIVEN_BACK || !matches!(rest.end, End::GaveUp(..)))
        {
            branch.orbits.truncate(from);
            branch.orbits.extend(rest.orbits);
            branch.end = rest.end;
            branch.work += rest.work;
        }
    }
    branch.time = clock.elapsed();
    Ok(branch)
}

/// One branch by shooting over this many segments.
fn stretch<M: Model<N>, const N: usize>(
    family: &SmoothFamily<M, N>,
    orbit: &Orbit<N, ()>,
    to: f64,
    segments: usize,
) -> Result<Followed<N>, FollowError> {
    let clock = Instant::now();
    let settings = Settings {
        largest_step: LARGEST_STEP,
        ..Settings::new(orbit.r, to, ACCURACY)
    };
    let search = Search {
        segments,
        ..search(orbit.place.state, Some(orbit.period))
    };
    let mut branch =
        OrbitBranch::start(family, orbit, &search, settings).map_err(FollowError::Start)?;
    let (mut orbits, mut work) = (Vec::new(), Work::default());
    let mut end = None;
    while end.is_none()
        && let Some(orbit) = branch.next()
    {
        work += orbit.work;
        orbits.push(orbit);
        end = vanishes(&orbits).or_else(|| folds(&mut orbits, to));
    }
    let last = orbits.last().map_or(orbit.r, |orbit| orbit.r);
    let end = end.unwrap_or_else(|| match branch.ending() {
        Some(Ending::Refused(FlowError::Vanished { .. })) => vanishing(&orbits),
        None | Some(Ending::ReachedEnd | Ending::ReachedStart) => End::Reached(last),
        Some(
            Ending::StepTooSmall(_)
            | Ending::Creeping(_)
            | Ending::TooManyPoints
            | Ending::Refused(_),
        ) => End::GaveUp(last),
    });
    Ok(Followed {
        orbits,
        end,
        time: clock.elapsed(),
        work,
    })
}

/// A cycle this small against the first one is about to vanish.
const SMALL: f64 = 2e-4;

/// Whether the cycle has nearly shrunk to an equilibrium.
fn vanishes<const N: usize>(orbits: &[Orbit<N, ()>]) -> Option<End> {
    let [first, .., last] = orbits else {
        return None;
    };
    (extent(last) < SMALL * extent(first)).then(|| vanishing(orbits))
}

/// Where the cycle will have vanished: the square of its extent is linear in r there.
fn vanishing<const N: usize>(orbits: &[Orbit<N, ()>]) -> End {
    let [.., before, last] = orbits else {
        return End::Vanishes(f64::NAN);
    };
    let (a, b) = (extent(before).powi(2), extent(last).powi(2));
    End::Vanishes(last.r - (last.r - before.r) * b / (b - a))
}

fn extent<const N: usize>(orbit: &Orbit<N, ()>) -> f64 {
    orbit.max[0] - orbit.min[0]
}

/// Steps backwards in a row that make a fold: one alone may be noise.
const BACKWARDS: usize = 3;

/// Whether the branch has turned back, and where; what lies beyond is taken off.
fn folds<const N: usize>(orbits: &mut Vec<Orbit<N, ()>>, to: f64) -> Option<End> {
    let direction = (to - orbits.first()?.r).signum();
    let turn = orbits.len().checked_sub(BACKWARDS + 1)?;
    let backwards = |pair: &[Orbit<N, ()>]| (pair[1].r - pair[0].r) * direction < 0.0;
    if !orbits[turn..].windows(2).all(backwards) {
        return None;
    }
    // Behind a fold the cycle is unstable; one that is not has lost its digits.
    let unstable = orbits.last()?.floquet.stability == Stability::Unstable;
    orbits.truncate(turn + 1);
    let r = orbits.last()?.r;
    Some(if unstable {
        End::Folds(r)
    } else {
        End::GaveUp(r)
    })
}

//! Following a curve, with what happens on it.

use std::ops::ControlFlow;

use super::codimension::Codimension;
use super::condition::Condition;
use super::critical::{CriticalProblem, CriticalShot, joined, split};
use super::plane::Plane;
use super::point::CurvePoint;
use crate::bifurcation::Kind;
use crate::continuation::{Branch, Ending, Failure, Link, Point, Settings, root};
use crate::field::Work;
use crate::flow::FlowError;
use crate::shooting::{Guess, Orbit, Solution, problem};

/// A multiplier this far off has left the condition.
const LOST: f64 = 1e-3;
/// The part along p that is left of a tangent at a cusp, relative to its neighbours.
const CUSP: f64 = 0.1;

/// A curve that has been followed.
#[derive(Debug, Clone)]
pub struct Curve {
    /// Which bifurcation it is one of.
    pub kind: Kind,
    /// Its points in the order in which they were found.
    pub points: Vec<CurvePoint>,
    /// Points of codimension two, in the same order.
    pub special: Vec<Found>,
    /// Why it ended.
    pub end: End,
    /// What it cost.
    pub work: Work,
}

/// A point of codimension two.
#[derive(Debug, Clone)]
pub struct Found {
    /// Which.
    pub codimension: Codimension,
    /// Where.
    pub point: CurvePoint,
}

/// Why a curve ended.
#[derive(Debug, Clone, PartialEq)]
pub enum End {
    /// As any branch does.
    Followed(Ending<FlowError>),
    /// p left its range.
    Window,
    /// Whoever watched wanted no more.
    Stopped,
    /// The bifurcation becomes another one here, or none: torus points a neutral saddle.
    Degenerate(Codimension),
    /// The multipliers do not say what the condition does any more: off by this.
    Lost(f64),
}

/// Follows the bifurcation `kind` that `orbit` meets at (p, q = settings.from) up to q = `settings.to`,
/// as long as p stays inside `window`; `watch` sees each point as it is found, and may end the curve there. `None` if there is no
/// condition for that kind.
///
/// # Errors
/// The first point cannot be converged on.
pub fn follow(
    plane: &Plane,
    kind: Kind,
    orbit: &Orbit,
    window: [f64; 2],
    settings: Settings,
    watch: &mut dyn FnMut(&CurvePoint) -> ControlFlow<()>,
) -> Result<Option<Curve>, Failure<FlowError>> {
    let Some(condition) = Condition::of(kind) else {
        return Ok(None);
    };
    let guess = Guess {
        place: orbit.place.clone(),
        period: orbit.period,
        magnitude: orbit.magnitude(),
    };
    let (p, q) = (orbit.r, settings.from);
    let family = plane.along_p(q).with_magnitude(&guess.magnitude);
    let (mut orbit_problem, z) = problem(family, p, &guess, 1).map_err(Failure::Evaluation)?;
    orbit_problem
        .float(&orbit.place, p)
        .map_err(Failure::Evaluation)?;
    let plane = Plane {
        family: plane.family.with_magnitude(&guess.magnitude),
        designs: plane.designs,
    };
    let scales = [
        (window[1] - window[0]).abs(),
        (settings.to - settings.from).abs(),
    ];
    let mut problem = CriticalProblem::new(plane, orbit_problem, condition, scales);
    let z = joined(&z, p);
    problem.align(&z, q).map_err(Failure::Evaluation)?;
    let (branch, first) = Branch::start(problem, z, settings)?;
    let mut walk = Walk {
        kind,
        window: [window[0].min(window[1]), window[0].max(window[1])],
        accuracy: settings.accuracy,
        scales,
        branch,
        points: Vec::new(),
        special: Vec::new(),
    };
    let end = walk.run(first, watch);
    Ok(Some(Curve {
        kind,
        work: walk.branch.problem.work(),
        points: walk.points,
        special: walk.special,
        end,
    }))
}

type Shown = Point<CriticalShot>;

/// A curve on the way.
struct Walk {
    kind: Kind,
    window: [f64; 2],
    accuracy: f64,
    scales: [f64; 2],
    branch: Branch<CriticalProblem>,
    points: Vec<CurvePoint>,
    special: Vec<Found>,
}

impl Walk {
    fn run(&mut self, first: Shown, watch: &mut dyn FnMut(&CurvePoint) -> ControlFlow<()>) -> End {
        let mut next = Some(first);
        while let Some(point) = next.take() {
            let mut spot = self.spot(&point);
            let off = self.condition().distance(&spot.floquet().multipliers);
            if off.is_nan() || off > LOST {
                return End::Lost(off);
            }
            let end = self.examine(&mut spot);
            let verdict = watch(&spot);
            self.points.push(spot);
            if let Some(end) = end {
                return end;
            }
            if verdict.is_break() {
                return End::Stopped;
            }
            next = self.branch.next();
        }
        let ending = self.branch.ending().cloned();
        End::Followed(ending.unwrap_or(Ending::TooManyPoints))
    }

    fn condition(&self) -> &Condition {
        self.branch.problem.condition()
    }

    /// Looks for what happens on the way to `spot`, and moves it to where the curve ends if it does.
    fn examine(&mut self, spot: &mut CurvePoint) -> Option<End> {
        let before = self.points.last()?.clone();
        let mut link = self.branch.link()?.clone();
        let [low, high] = self.window;
        let mut end = None;
        for bound in [low, high] {
            let past = |point: &CurvePoint| point.p - bound;
            if past(&before) * past(spot) < 0.0 {
                let ends = [past(&before), past(spot)];
                if let Some(found) = self.locate(&mut link, ends, &|point| Some(past(point))) {
                    *spot = found;
                }
                end = Some(End::Window);
            }
        }
        for codimension in Codimension::ALL {
            let test = |point: &CurvePoint| codimension.test(self.kind, point);
            let (Some(a), Some(b)) = (test(&before), test(spot)) else {
                continue;
            };
            if a * b >= 0.0 {
                continue;
            }
            let Some(found) = self.locate(&mut link, [a, b], &test) else {
                continue;
            };
            if codimension == Codimension::Cusp && !self.is_cusp(&before, &found, spot) {
                continue;
            }
            if codimension.ends(self.kind) {
                *spot = found.clone();
                end = Some(End::Degenerate(codimension));
            }
            self.special.push(Found {
                codimension,
                point: found,
            });
        }
        end
    }

    /// Whether the curve stands still in p too where it turns in q.
    fn is_cusp(&self, before: &CurvePoint, found: &CurvePoint, after: &CurvePoint) -> bool {
        let along_p = |point: &CurvePoint| point.tangent[0].abs();
        along_p(found) <= CUSP * along_p(before).max(along_p(after))
    }

    /// The point of the last step at which `test` vanishes.
    fn locate(
        &self,
        link: &mut Link<CriticalProblem>,
        [a, b]: [f64; 2],
        test: &dyn Fn(&CurvePoint) -> Option<f64>,
    ) -> Option<CurvePoint> {
        let mut best: Option<(f64, CurvePoint)> = None;
        root(a, b, |share| {
            let point = link.between(share).ok()?;
            let spot = self.spot(&point);
            let value = test(&spot)?;
            let last = best.as_ref().map(|(_, spot)| [spot.p, spot.q]);
            let settled = last.is_some_and(|[p, q]| {
                let moved = [(spot.p - p) / self.scales[0], (spot.q - q) / self.scales[1]];
                moved.iter().all(|moved| moved.abs() <= 0.1 * self.accuracy)
            });
            if best
                .as_ref()
                .is_none_or(|(least, _)| value.abs() <= least.abs())
            {
                best = Some((value, spot));
            }
            Some(if settled { 0.0 } else { value })
        });
        best.map(|(_, spot)| spot)
    }

    fn spot(&self, point: &Shown) -> CurvePoint {
        let (z, p) = split(&point.z);
        let family = self.branch.problem.plane.along_p(point.r);
        let solution = Solution {
            shot: &point.extra.shot,
            z: &z,
            r: p,
            residual: point.residual,
        };
        let orbit = Orbit::read(&family, solution, self.accuracy, Work::default());
        let last = point.tangent.len() - 1;
        CurvePoint {
            p,
            q: point.r,
            orbit,
            test: point.extra.test,
            tangent: [point.tangent[last - 1], point.tangent[last]],
        }
    }
}

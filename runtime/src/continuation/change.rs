//! Where a branch passes from one regime to another.

use super::path::{Border, Path, Spot, Watched};

const ITERATIONS: usize = 60;
/// Halvings after each of which the change is sought as a point of its own, and up to which.
const EVERY: usize = 4;
const SOUGHT: usize = 24;
/// Part of the accuracy asked for to which r is bracketed.
const SETTLED: f64 = 0.01;
/// Relative width of a bracket that cannot be made smaller, beyond which nothing is located.
const WIDE: f64 = 1e-6;
/// Where in a bracket the next point is tried: in the middle, elsewhere if there is none.
const TRIALS: [f64; 5] = [0.5, 0.3, 0.7, 0.1, 0.9];
/// Part of a bracket beside a point of its own at which the regimes must be those on its two sides.
const BESIDE: f64 = 1e-2;

/// The points on both sides of a change of regime, each nearer to it than the one before.
pub(super) struct Change<P> {
    pub(super) before: Vec<Spot<P>>,
    pub(super) after: Vec<Spot<P>>,
    /// The change as a point of its own.
    pub(super) border: Option<Border<P>>,
}

impl<P: Watched> Change<P> {
    /// The two nearest to it.
    pub(super) fn nearest(&self) -> [&Spot<P>; 2] {
        [&self.before, &self.after].map(|side| &side[side.len() - 1])
    }

    /// Whether r is known well enough.
    pub(super) fn is_sharp(&self) -> bool {
        self.border.is_some() || width(self.nearest()) <= WIDE
    }
}

/// Brackets the first change of regime between two spots whose regimes differ.
pub(super) fn change<Q: Path>(
    path: &mut Q,
    [from, to]: [&Spot<Q::Point>; 2],
    accuracy: f64,
) -> Change<Q::Point> {
    let mut found = Change {
        before: vec![from.clone()],
        after: vec![to.clone()],
        border: None,
    };
    for iteration in 0..ITERATIONS {
        let ends = found.nearest();
        if width(ends) <= SETTLED * accuracy {
            break;
        }
        let due = iteration % EVERY == 0 && iteration <= SOUGHT;
        if due && let Some((border, [before, after])) = of_its_own(path, ends) {
            found.before.push(before);
            found.after.push(after);
            found.border = Some(border);
            break;
        }
        let Some(spot) = try_between(path, ends) else {
            break;
        };
        if spot.point.same_regime(&from.point) {
            found.before.push(spot);
        } else if spot.point.same_regime(&ends[1].point) {
            found.after.push(spot);
        } else {
            found.after = vec![spot];
        }
    }
    found
}

fn width<P: Watched>([a, b]: [&Spot<P>; 2]) -> f64 {
    let r = a.point.r();
    (b.point.r() - r).abs() / r.abs().max(f64::MIN_POSITIVE)
}

/// The change as a point of its own, if beside it nothing else happens, and the points there.
fn of_its_own<Q: Path>(
    path: &mut Q,
    [low, high]: [&Spot<Q::Point>; 2],
) -> Option<(Border<Q::Point>, [Spot<Q::Point>; 2])> {
    let border = path.border([&low.point, &high.point])?;
    let width = high.share - low.share;
    let share = low.share + border.share * width;
    let mut beside = |share: f64, end: &Spot<Q::Point>| {
        if share <= low.share || share >= high.share {
            return Some(end.clone());
        }
        let point = path.at(share).ok()?;
        point
            .same_regime(&end.point)
            .then_some(Spot { share, point })
    };
    let before = beside(share - BESIDE * width, low)?;
    let after = beside(share + BESIDE * width, high)?;
    Some((Border { share, ..border }, [before, after]))
}

fn try_between<Q: Path>(path: &mut Q, [low, high]: [&Spot<Q::Point>; 2]) -> Option<Spot<Q::Point>> {
    TRIALS.iter().find_map(|part| {
        let share = low.share + part * (high.share - low.share);
        let inside = share > low.share && share < high.share;
        let point = inside.then(|| path.at(share).ok()).flatten()?;
        Some(Spot { share, point })
    })
}

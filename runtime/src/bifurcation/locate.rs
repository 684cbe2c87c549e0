//! Where on a path a function of its points vanishes.

use super::watched::{Path, Spot, Watched};

const ITERATIONS: usize = 40;
/// Part of the accuracy asked for at which r has converged.
const SETTLED: f64 = 0.01;

/// Width of a bracket, as a share of the path, at which a point that cannot be found ends the search.
const NARROW: f64 = 1e-4;
/// Distance, as a part of the bracket, at which another point is tried instead.
const BESIDE: f64 = 0.01;

/// The point at this share, or next to it: at a branch point itself the corrector is singular.
fn beside<Q: Path>(
    path: &mut Q,
    share: f64,
    [low, high]: [f64; 2],
) -> Result<(f64, Q::Point), Q::Error> {
    let error = match path.at(share) {
        Ok(point) => return Ok((share, point)),
        Err(error) => error,
    };
    let other = [share + BESIDE * (high - low), share - BESIDE * (high - low)];
    let inside = other
        .into_iter()
        .filter(|share| *share > low && *share < high);
    let mut found = inside.filter_map(|share| Some((share, path.at(share).ok()?)));
    found.next().ok_or(error)
}

/// The point of a path between `from` and `to` at which the design variable is `r`, if it is there.
///
/// # Errors
/// A point on the way could not be found.
pub fn reach<Q: Path>(
    path: &mut Q,
    [from, to]: [&Q::Point; 2],
    r: f64,
    accuracy: f64,
) -> Result<Option<Q::Point>, Q::Error> {
    if (from.r() - r) * (to.r() - r) > 0.0 {
        return Ok(None);
    }
    let spot = |share, point: &Q::Point| Spot {
        share,
        point: point.clone(),
    };
    let ends = [&spot(0.0, from), &spot(1.0, to)];
    zero(path, ends, |point| point.r() - r, accuracy).map(|at| Some(at.point))
}

/// The zero between two spots at which `test` has different signs: regula falsi with Illinois' rule,
/// and halving where that is too slow.
pub(super) fn zero<Q: Path>(
    path: &mut Q,
    [a, b]: [&Spot<Q::Point>; 2],
    test: impl Fn(&Q::Point) -> f64,
    accuracy: f64,
) -> Result<Spot<Q::Point>, Q::Error> {
    let (mut low, mut high) = ((a.share, test(&a.point)), (b.share, test(&b.point)));
    let mut best = if low.1.abs() < high.1.abs() {
        a.clone()
    } else {
        b.clone()
    };
    let (mut width, mut raised) = (high.0 - low.0, None);
    for iteration in 0..ITERATIONS {
        let slow = iteration % 4 == 3 && high.0 - low.0 > 0.5 * width;
        if iteration % 4 == 3 {
            width = high.0 - low.0;
        }
        let secant = low.0 - low.1 * (high.0 - low.0) / (high.1 - low.1);
        let inside = secant > low.0 && secant < high.0;
        let share = if inside && !slow {
            secant
        } else {
            0.5 * (low.0 + high.0)
        };
        if share <= low.0 || share >= high.0 {
            break;
        }
        let (share, point) = match beside(path, share, [low.0, high.0]) {
            Ok(found) => found,
            // As near as the corrector comes to where it is singular.
            Err(_) if high.0 - low.0 < NARROW => break,
            Err(error) => return Err(error),
        };
        let value = test(&point);
        let moved = (point.r() - best.point.r()).abs();
        let settled = moved <= SETTLED * accuracy * point.r().abs();
        best = Spot { share, point };
        if value == 0.0 || (settled && !slow && iteration > 1) {
            break;
        }
        let raises = value * low.1 > 0.0;
        let again = raised == Some(raises);
        if raises {
            low = (share, value);
            high.1 *= if again { 0.5 } else { 1.0 };
        } else {
            high = (share, value);
            low.1 *= if again { 0.5 } else { 1.0 };
        }
        raised = Some(raises);
    }
    Ok(best)
}

//! Where on a path a function of its points vanishes.

use super::watched::{Path, Spot, Watched};

const ITERATIONS: usize = 40;
/// Part of the accuracy asked for at which r has converged.
const SETTLED: f64 = 0.01;

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
        let point = path.at(share)?;
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

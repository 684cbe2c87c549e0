//! Where on a path a function of its points vanishes.

use super::monitor::Monitor;
use super::path::{Path, Spot, Watched};

const ITERATIONS: usize = 120;
/// Secants after which a bracket that is no half of what it was is halved; once that was so, after each.
const PATIENCE: usize = 3;
/// Part of the accuracy asked for at which a point has converged, and that the error of one that was found as such cannot
/// be less than: two runs may agree by chance.
pub(crate) const SETTLED: f64 = 0.01;
/// Part of the accuracy, being some times the tolerance of a motion between two points, that the error of a zero cannot be
/// less than.
const CHANCE: f64 = 0.08;
/// Width of a bracket, as a share of the path, at which a point that cannot be found ends the search.
const NARROW: f64 = 1e-4;
/// Distance from a zero, as a share of the path, from which on slopes there are not all rounding.
const NEIGHBOUR: f64 = 1e-3;
/// Differences of a function that tell its slope, in units of what rounding leaves uncertain of it.
const STANDS_OUT: f64 = 4.0;
/// What is reported over what two runs differ by: they share part of their errors.
pub(super) const DOUBT: f64 = 1.5;
/// Distance, as a part of the bracket, at which another point is tried instead.
const BESIDE: f64 = 0.01;

/// The point at this share, or next to it: at a branch point itself the corrector is singular.
fn beside<Q: Path>(
    path: &mut Q,
    share: f64,
    [low, high]: [f64; 2],
) -> Result<Spot<Q::Point>, Q::Error> {
    let error = match path.at(share) {
        Ok(point) => return Ok(Spot { share, point }),
        Err(error) => error,
    };
    let off = BESIDE * (high - low);
    let inside = [share + off, share - off].into_iter();
    let mut inside = inside.filter(|share| *share > low && *share < high);
    let found = inside.find_map(|share| {
        let point = path.at(share).ok()?;
        Some(Spot { share, point })
    });
    found.ok_or(error)
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
    let ends = [&Spot::new(0.0, from), &Spot::new(1.0, to)];
    zero(path, ends, |point| point.r() - r, accuracy).map(|at| Some(at.spot.point))
}

/// What is read at a point: its share of the path, the function, r, and how long what is followed takes.
type Seen = (f64, [f64; 3]);

/// A zero, and what was seen on the way to it.
pub(super) struct Zero<P> {
    pub(super) spot: Spot<P>,
    /// The value there.
    value: f64,
    others: Vec<Seen>,
    /// The share of the path on which it was looked for.
    width: f64,
}

impl<P: Watched> Zero<P> {
    /// What of the others is nearest at this distance or farther, if its value differs by more than this.
    fn beyond(&self, least: f64, differing: f64) -> Option<&Seen> {
        let off = |other: &&Seen| (other.0 - self.spot.share).abs();
        let tells = |other: &&Seen| (other.1[0] - self.value).abs() > differing;
        let far = (self.others.iter()).filter(|other| off(other) >= least && tells(other));
        far.min_by(|a, b| off(a).total_cmp(&off(b)))
    }

    /// How the function, r, and how long what is followed takes change with the share of the path: from another spot, not too
    /// near to this one, nor so that rounding decides.
    fn slopes(&self, rounding: f64) -> [f64; 3] {
        let point = &self.spot.point;
        let here = [self.value, point.r(), point.lasts()];
        let other = self.beyond(NEIGHBOUR * self.width, STANDS_OUT * rounding);
        other.map_or([f64::NAN; 3], |(share, other)| {
            [0, 1, 2].map(|i| (here[i] - other[i]) / (self.spot.share - share))
        })
    }

    /// How far r is from the point that was found next to it; from all that were seen, if none of them stands out.
    fn apart(&self, stands_out: bool) -> f64 {
        let off = |other: &Seen| (other.1[1] - self.spot.point.r()).abs();
        if stands_out {
            let nearest = self.beyond(f64::MIN_POSITIVE, f64::NEG_INFINITY);
            nearest.map_or(0.0, off)
        } else {
            self.others.iter().map(off).fold(0.0, f64::max)
        }
    }

    /// The estimated errors of r, of this size next to it, and of how long what is followed takes: from the same point once more, and from what
    /// rounding leaves uncertain; where that says nothing of r, from the point found next to it.
    pub(super) fn errors<Q: Path<Point = P>>(
        &self,
        path: &mut Q,
        Monitor { test, rounding, .. }: &Monitor<'_, P>,
        (accuracy, size): (f64, f64),
    ) -> [f64; 2] {
        let at = &self.spot.point;
        let [slope, along, lasting] = self.slopes(rounding(at));
        let measured = path.again(self.spot.share).map(|again| {
            let apart = (test(&again) - test(at)).abs() + rounding(at);
            let off = apart / slope * along;
            let moved = (again.r() - at.r()).abs() + off.abs();
            // What is left of the function is nothing to an r that turns there.
            let off = (apart + test(at).abs()) / slope * lasting;
            let lasts = (again.lasts() - at.lasts()).abs() + off.abs();
            [
                DOUBT * moved + CHANCE * accuracy * size,
                DOUBT * lasts + CHANCE * accuracy * at.lasts(),
            ]
        });
        let [moved, lasts] = measured.unwrap_or([f64::NAN; 2]);
        let beside = DOUBT * (self.apart(slope.is_finite()) + accuracy * size);
        [if moved.is_finite() { moved } else { beside }, lasts]
    }
}

/// The zero between two spots at which `test` has different signs: regula falsi with Illinois' rule,
/// and halving where that is too slow.
pub(super) fn zero<Q: Path>(
    path: &mut Q,
    [a, b]: [&Spot<Q::Point>; 2],
    test: impl Fn(&Q::Point) -> f64,
    accuracy: f64,
) -> Result<Zero<Q::Point>, Q::Error> {
    let seen = |spot: &Spot<Q::Point>| {
        let point = &spot.point;
        (spot.share, [test(point), point.r(), point.lasts()])
    };
    let (whole, mut others) = (b.share - a.share, vec![seen(a), seen(b)]);
    let (mut low, mut high) = ((a.share, test(&a.point)), (b.share, test(&b.point)));
    let nearer = if low.1.abs() < high.1.abs() { a } else { b };
    let mut best = nearer.clone();
    let (mut width, mut raised) = (high.0 - low.0, None);
    let (mut secants, mut patience, mut last) = (0, PATIENCE, f64::INFINITY);
    for iteration in 0..ITERATIONS {
        let due = secants >= patience;
        let slow = due && high.0 - low.0 > 0.5 * width;
        if due {
            // Of what the secants that follow are to be judged by, halving is no part.
            width = (high.0 - low.0) * if slow { 0.5 } else { 1.0 };
            patience = if slow { 1 } else { PATIENCE };
        }
        secants = if due { 0 } else { secants + 1 };
        let secant = low.0 - low.1 * (high.0 - low.0) / (high.1 - low.1);
        let inside = secant > low.0 && secant < high.0;
        let middle = 0.5 * (low.0 + high.0);
        let share = if inside && !slow { secant } else { middle };
        if share <= low.0 || share >= high.0 {
            break;
        }
        let spot = match beside(path, share, [low.0, high.0]) {
            Ok(found) => found,
            // As near as the corrector comes to where it is singular.
            Err(_) if high.0 - low.0 < NARROW => break,
            Err(error) => return Err(error),
        };
        let value = test(&spot.point);
        // A secant that creeps along a flat stretch moves little as well, but changes nothing.
        let nears = value.abs() <= 0.5 * last.abs() || (value < 0.0) != (last < 0.0);
        // Where r turns it moves with the square of the way.
        let still = (spot.share - best.share).abs() <= (SETTLED * accuracy).sqrt();
        let settled = spot.point.moved(&best.point) <= SETTLED * accuracy && nears && still;
        others.push(seen(&spot));
        (best, last) = (spot, value);
        if value == 0.0 || (settled && !slow && iteration > 1) {
            break;
        }
        // An end that stays put twice counts half, so that the secant cannot lean on it for ever.
        let raises = value * low.1 > 0.0;
        let again = raised == Some(raises);
        if raises {
            low = (best.share, value);
            high.1 *= if again { 0.5 } else { 1.0 };
        } else {
            high = (best.share, value);
            low.1 *= if again { 0.5 } else { 1.0 };
        }
        raised = Some(raises);
    }
    let value = test(&best.point);
    Ok(Zero {
        spot: best,
        value,
        others,
        width: whole,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Clone)]
    struct Number(f64);

    impl Watched for Number {
        fn r(&self) -> f64 {
            self.0
        }

        fn r_scale(&self) -> f64 {
            self.0.abs()
        }

        fn slope(&self) -> f64 {
            1.0
        }
    }

    struct Line(usize);

    impl Path for Line {
        type Point = Number;
        type Error = &'static str;

        fn at(&mut self, share: f64) -> Result<Number, &'static str> {
            self.0 += 1;
            Ok(Number(share))
        }
    }

    #[test]
    fn a_root_behind_a_long_flat_stretch_is_found() {
        let ends = [&Spot::new(0.0, &Number(0.0)), &Spot::new(1.0, &Number(1.0))];
        let test = |x: &Number| (x.0 - 0.7).max(0.0).sqrt() - 1e-8;
        let mut line = Line(0);
        let found = zero(&mut line, ends, test, 1e-12).unwrap();
        assert!(
            (found.spot.point.0 - 0.7).abs() < 1e-14,
            "{}",
            found.spot.point.0
        );
        assert!(line.0 < 110, "{}", line.0);
    }

    #[test]
    fn a_root_is_found_to_its_accuracy() {
        let ends = [&Spot::new(0.0, &Number(0.0)), &Spot::new(1.0, &Number(1.0))];
        let test = |x: &Number| (x.0 - 0.3).exp() - 1.0 + (x.0 - 0.3).powi(3);
        let mut line = Line(0);
        let found = zero(&mut line, ends, test, 1e-12).unwrap();
        assert!(
            (found.spot.point.0 - 0.3).abs() < 1e-14,
            "{}",
            found.spot.point.0
        );
        assert!(line.0 < 30, "{}", line.0);
    }
}

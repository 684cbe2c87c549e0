//! Where a branch passes from one regime to another.

use super::exchange::{self, Exchange};
use super::margin;
use super::path::{Border, Path, Spot, Watched};
use super::root::SETTLED;

const ITERATIONS: usize = 60;
/// Halvings after each of which the change is sought as a point of its own, and up to which.
const EVERY: usize = 4;
const SOUGHT: usize = 24;
/// Relative width of a bracket that cannot be made smaller, beyond which nothing is located.
const WIDE: f64 = 1e-6;
/// Where else in a bracket the next point is tried if there is none.
const TRIALS: [f64; 5] = [0.5, 0.3, 0.7, 0.1, 0.9];
/// Share of the step that such a bracket may be: where r turns, it does not change much either.
const APART: f64 = 1e-3;
/// Points of a path that are tried beside a border that something lies next to.
const BESIDE: usize = 40;

/// The points on both sides of a change of regime, each nearer to it than the one before.
pub(super) struct Change<P> {
    pub(super) before: Vec<Spot<P>>,
    pub(super) after: Vec<Spot<P>>,
    /// The change as a point of its own.
    pub(super) border: Option<Border<P>>,
    /// The point at which two events that exchange their order happen at once, and the estimated error of r there.
    pub(super) meeting: Option<(Spot<P>, f64)>,
}

impl<P: Watched> Change<P> {
    /// The two nearest to it.
    pub(super) fn nearest(&self) -> [&Spot<P>; 2] {
        [&self.before, &self.after].map(|side| &side[side.len() - 1])
    }

    /// Whether r is known well enough.
    pub(super) fn is_sharp(&self) -> bool {
        let [before, after] = self.nearest();
        let narrow = width([before, after]) <= WIDE && after.share - before.share <= APART;
        self.border.is_some() || self.meeting.is_some() || narrow
    }

    /// r of the change within the bracket, and its error: where a margin vanishes, if that tells it better than the bracket.
    pub(super) fn within(&self, accuracy: f64) -> (f64, f64) {
        let nearest = self.nearest().map(|spot| &spot.point);
        let [low, high] = nearest.map(Watched::r);
        let middle = f64::midpoint(low, high);
        // Each end is an orbit that is known to the accuracy, and so are its events.
        let least = accuracy * (nearest[0].r_size() + self.drift([low, high]));
        let sides = [&self.before, &self.after];
        let zeros = sides.map(|side| margin::vanishes(side, [low, high]));
        let bracket = (middle, 0.5 * (high - low).abs());
        let zeros = zeros.into_iter().flatten();
        let (r, error) = zeros.fold(bracket, |a, b| if b.1 < a.1 { b } else { a });
        (r, error + least)
    }

    /// How far r moves over as much as the whole of what is followed lasts, if with it the stretch changes that vanishes within
    /// the bracket: by the nearest point that is far from it beside its width.
    fn drift(&self, [low, high]: [f64; 2]) -> f64 {
        let [before, after] = self.nearest().map(|spot| &spot.point);
        let middle = f64::midpoint(low, high);
        let away = |point: &P| (point.r() - middle).abs();
        let of = |(side, other): (&[Spot<P>], &P)| {
            let mut points = side.iter().rev().map(|spot| &spot.point);
            let point = points.find(|point| away(point) > margin::FAR * (high - low).abs())?;
            let lasts = point.besides(other).filter(|lasts| *lasts > 0.0)?;
            Some(point.lasts() * away(point) / lasts)
        };
        let sides = [(&self.before[..], after), (&self.after[..], before)];
        sides.into_iter().filter_map(of).fold(0.0, f64::max)
    }

    /// Points of the path so near to the border, on both sides of it, that nothing `passes` between them and it: where it lies
    /// on the path is known only about, and what happens next to it would be sought where it is not. `None` if nothing
    /// passes as it is, or if there are none.
    pub(super) fn beside<Q>(
        &mut self,
        path: &mut Q,
        passes: impl Fn([&P; 2]) -> bool,
    ) -> Option<[Spot<P>; 2]>
    where
        Q: Path<Point = P>,
    {
        let border = self.border.as_ref()?;
        let [come, left] = &border.points;
        let next = |low: &P, high: &P| passes([low, come]) || !border.last && passes([left, high]);
        let nearest = |side: &[Spot<P>]| side.iter().nth_back(1).cloned();
        let (mut low, mut high) = (nearest(&self.before)?, nearest(&self.after)?);
        let (mut share, mut tried) = (border.share, 0);
        while next(&low.point, &high.point) {
            let inside = share > low.share && share < high.share;
            let point = path.at(share).ok().filter(|_| inside && tried < BESIDE)?;
            if point.same_regime(&low.point) {
                low = Spot { share, point };
            } else if point.same_regime(&high.point) {
                high = Spot { share, point };
            } else {
                return None;
            }
            share = 0.5 * (low.share + high.share);
            tried += 1;
        }
        if tried == 0 {
            return None;
        }
        for side in [&mut self.before, &mut self.after] {
            side.last_mut()?.share = share;
        }
        Some([low, high])
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
        meeting: None,
    };
    let mut falsi = Exchange::within(to.share - from.share);
    for iteration in 0..ITERATIONS {
        let ends = found.nearest();
        if let Some(spot) = exchange::met(ends, accuracy) {
            let error = exchange::error(path, ends, accuracy);
            found.meeting = Some((spot, error));
            break;
        }
        if width(ends) <= SETTLED * accuracy && !exchange::turns(ends) {
            break;
        }
        let due = iteration % EVERY == 0 && iteration <= SOUGHT;
        if due && let Some(mut border) = path.border([&ends[0].point, &ends[1].point]) {
            let share = ends[0].share + border.share * (ends[1].share - ends[0].share);
            border.share = share;
            let [come, left] = border.points.clone();
            found.before.push(Spot { share, point: come });
            found.after.push(Spot { share, point: left });
            found.border = Some(border);
            break;
        }
        let Some(spot) = try_between(path, ends, falsi.part(ends)) else {
            break;
        };
        if spot.point.same_regime(&from.point) {
            falsi.replaced(0);
            found.before.push(spot);
        } else if spot.point.same_regime(&ends[1].point) {
            falsi.replaced(1);
            found.after.push(spot);
        } else if let Some([left, right]) = exchange::beside(path, &spot, ends) {
            let error = exchange::error(path, [&left, &right], accuracy);
            found.meeting = Some((spot, error));
            found.before.push(left);
            found.after.push(right);
            break;
        } else {
            falsi = Exchange::within(spot.share - ends[0].share);
            found.after = vec![spot];
        }
    }
    found
}

fn width<P: Watched>([a, b]: [&Spot<P>; 2]) -> f64 {
    (b.point.r() - a.point.r()).abs() / a.point.r_size().max(f64::MIN_POSITIVE)
}

fn try_between<Q: Path>(
    path: &mut Q,
    [low, high]: [&Spot<Q::Point>; 2],
    first: f64,
) -> Option<Spot<Q::Point>> {
    std::iter::once(&first).chain(&TRIALS).find_map(|part| {
        let share = low.share + part * (high.share - low.share);
        let inside = share > low.share && share < high.share;
        let point = inside.then(|| path.at(share).ok()).flatten()?;
        Some(Spot { share, point })
    })
}

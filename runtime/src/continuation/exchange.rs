//! Where on a path two events exchange their order.

use super::monitor::changes;
use super::path::{Path, Spot, Watched};
use super::root::{DOUBT, SETTLED};

/// Points after which a bracket that is no half of what it was is halved.
const PATIENCE: usize = 3;
const MIDDLE: f64 = 0.5;
/// Where beside a point at which both happen at once they are looked for again, as shares of the way to either end: nearer,
/// they may be one as far as their digits tell.
const BESIDE: [f64; 3] = [1e-3, 1e-2, 1e-1];

/// Regula falsi with Illinois' rule on the time between both events; halving where it is slow, and where regimes differ
/// by more.
pub(super) struct Exchange {
    weights: [f64; 2],
    last: Option<usize>,
    /// The width that is to be halved, and the points since.
    width: f64,
    points: usize,
}

impl Exchange {
    /// On a bracket of this width.
    pub(super) fn within(width: f64) -> Self {
        Self {
            weights: [1.0; 2],
            last: None,
            width,
            points: 0,
        }
    }

    /// Where in the bracket to look next.
    pub(super) fn part<P: Watched>(&mut self, ends: [&Spot<P>; 2]) -> f64 {
        self.points += 1;
        let width = ends[1].share - ends[0].share;
        let due = self.points > PATIENCE;
        let slow = due && width > 0.5 * self.width;
        if due {
            (self.width, self.points) = (width, 0);
        }
        let Some([before, after]) = times(ends) else {
            return MIDDLE;
        };
        let [before, after] = [before * self.weights[0], after * self.weights[1]];
        let part = before / (before + after);
        let inside = part > 0.0 && part < 1.0;
        if inside && !slow { part } else { MIDDLE }
    }

    /// An end that stays put twice counts half.
    pub(super) fn replaced(&mut self, end: usize) {
        self.weights[end] = 1.0;
        if self.last == Some(end) {
            self.weights[1 - end] *= 0.5;
        }
        self.last = Some(end);
    }
}

/// Whether r turns between both ends: how near they are in it says nothing then.
pub(super) fn turns<P: Watched>(ends: [&Spot<P>; 2]) -> bool {
    let [from, to] = ends.map(|spot| spot.point.slope());
    changes(from, to)
}

/// Where both events happen at once, as far as r can tell at `accuracy`: at an end.
pub(super) fn met<P: Watched>(ends: [&Spot<P>; 2], accuracy: f64) -> Option<Spot<P>> {
    let times = times(ends).filter(|_| !turns(ends))?;
    let nearer = ends[usize::from(times[1] < times[0])];
    let off = times[0].min(times[1]) * rate(ends, times);
    (off.abs() <= SETTLED * accuracy * nearer.point.r_size()).then(|| nearer.clone())
}

/// The points just before and after `spot` between these ends, if both events happen at once there and nowhere beside it.
pub(super) fn beside<Q: Path>(
    path: &mut Q,
    spot: &Spot<Q::Point>,
    ends: [&Spot<Q::Point>; 2],
) -> Option<[Spot<Q::Point>; 2]> {
    let at_once = |end: &&Spot<Q::Point>| spot.point.exchanged(&end.point) == Some(0.0);
    if !ends.iter().all(at_once) {
        return None;
    }
    let mut next = |end: &Spot<Q::Point>| {
        BESIDE.into_iter().find_map(|part| {
            let share = spot.share + part * (end.share - spot.share);
            let point = path.at(share).ok()?;
            let same = point.same_regime(&end.point);
            same.then_some(Spot { share, point })
        })
    };
    Some([next(ends[0])?, next(ends[1])?])
}

/// The estimated error of r where both events happen at once: from the points at the ends once more.
pub(super) fn error<Q: Path>(path: &mut Q, ends: [&Spot<Q::Point>; 2], accuracy: f64) -> f64 {
    let mut measured = || {
        let times = times(ends)?;
        let mut moved: Option<f64> = None;
        for end in 0..2 {
            let [at, other] = [ends[end], ends[1 - end]].map(|end| &end.point);
            let again = path.again(ends[end].share)?;
            // Where the order is lost to rounding, the other end has to tell.
            let Some(time) = again.exchanged(other) else {
                continue;
            };
            let later = (time - times[end]) * rate(ends, times);
            let off = (again.r() - at.r()).abs() + later.abs();
            moved = Some(moved.map_or(off, |most| most.max(off)));
        }
        let point = &ends[0].point;
        // Events are those of the last motion, one correction away from the point.
        let off = point.r_size() + (point.lasts() * rate(ends, times)).abs();
        Some(DOUBT * moved? + accuracy * off)
    };
    measured().unwrap_or(f64::NAN)
}

/// How r changes with the time between both events.
fn rate<P: Watched>([a, b]: [&Spot<P>; 2], times: [f64; 2]) -> f64 {
    (b.point.r() - a.point.r()) / (times[0] + times[1])
}

/// The times between both events at both ends.
fn times<P: Watched>([a, b]: [&Spot<P>; 2]) -> Option<[f64; 2]> {
    Some([a.point.exchanged(&b.point)?, b.point.exchanged(&a.point)?])
}

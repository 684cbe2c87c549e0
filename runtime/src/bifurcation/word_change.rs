//! Where the event word changes, and why.

use super::Kind;
use super::watched::{Margin, Path, Spot, Watched};

const ITERATIONS: usize = 60;
/// Part of the accuracy asked for to which r is bracketed.
const SETTLED: f64 = 0.01;
/// Relative width of a bracket that cannot be made smaller, beyond which nothing is located.
const WIDE: f64 = 1e-6;
/// A margin that has shrunk to this share of its largest value vanishes at the change.
const SHRUNK: f64 = 1e-2;
/// Where in a bracket the next point is tried: in the middle, elsewhere if there is none.
const TRIALS: [f64; 5] = [0.5, 0.3, 0.7, 0.1, 0.9];

/// The two sides of a change of word, as near to it as can be.
pub(super) struct Change<P> {
    pub(super) before: Spot<P>,
    pub(super) after: Spot<P>,
    pub(super) kind: Kind,
    /// Whether r is known well enough.
    pub(super) sharp: bool,
}

/// Brackets the first change of word between two spots whose words differ, and classifies it.
pub(super) fn word_change<Q: Path>(
    path: &mut Q,
    from: &Spot<Q::Point>,
    to: &Spot<Q::Point>,
    accuracy: f64,
) -> Change<Q::Point> {
    let (mut before, mut after) = (vec![from.clone()], vec![to.clone()]);
    for _ in 0..ITERATIONS {
        let (low, high) = (&before[before.len() - 1], &after[after.len() - 1]);
        if width(low, high) <= SETTLED * accuracy {
            break;
        }
        let Some(spot) = try_between(path, low, high) else {
            break;
        };
        if spot.point.same_word(&from.point) {
            before.push(spot);
        } else if spot.point.same_word(&high.point) {
            after.push(spot);
        } else {
            after = vec![spot];
        }
    }
    let kind = classify(&before, &after);
    let [before, after] = [before, after].map(|spots| spots[spots.len() - 1].clone());
    Change {
        sharp: width(&before, &after) <= WIDE,
        before,
        after,
        kind,
    }
}

fn width<P: Watched>(a: &Spot<P>, b: &Spot<P>) -> f64 {
    let r = a.point.r();
    (b.point.r() - r).abs() / r.abs().max(f64::MIN_POSITIVE)
}

fn try_between<Q: Path>(
    path: &mut Q,
    low: &Spot<Q::Point>,
    high: &Spot<Q::Point>,
) -> Option<Spot<Q::Point>> {
    TRIALS.iter().find_map(|part| {
        let share = low.share + part * (high.share - low.share);
        let inside = share > low.share && share < high.share;
        let point = inside.then(|| path.at(share).ok()).flatten()?;
        Some(Spot { share, point })
    })
}

/// The margin that vanishes: on the side of the shorter word what is about to happen, else on the
/// side of the longer one what is about to be missed.
fn classify<P: Watched>(before: &[Spot<P>], after: &[Spot<P>]) -> Kind {
    let length = |side: &[Spot<P>]| side.first().map_or(0, |spot| spot.point.word_length());
    let (short, long) = if length(before) <= length(after) {
        (before, after)
    } else {
        (after, before)
    };
    let happens = vanishing(short, Watched::near_misses);
    happens
        .or_else(|| vanishing(long, Watched::close_calls))
        .unwrap_or(Kind::VanishingSegment)
}

/// The kind of the margin that has shrunk most towards the last of these spots.
fn vanishing<P: Watched>(spots: &[Spot<P>], margins: fn(&P) -> Vec<Margin>) -> Option<Kind> {
    let smallest = |spot: &Spot<P>, wanted: &Margin| {
        let all = margins(&spot.point).into_iter();
        let same = all.filter(|m| m.kind == wanted.kind && m.contact == wanted.contact);
        same.map(|m| m.value).min_by(f64::total_cmp)
    };
    let shrunk = |near: &Margin| {
        let largest = spots.iter().filter_map(|spot| smallest(spot, near));
        near.value / largest.fold(f64::MIN_POSITIVE, f64::max)
    };
    let last = margins(&spots.last()?.point);
    let ratios = last.iter().map(|margin| (margin.kind, shrunk(margin)));
    let (kind, ratio) = ratios.min_by(|a, b| a.1.total_cmp(&b.1))?;
    (ratio <= SHRUNK).then_some(kind)
}

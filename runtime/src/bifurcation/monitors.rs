//! What is looked for on a branch of periodic orbits.

use super::Kind;
use super::growth::Growths;
use super::periodic::PeriodicPoint;
use super::test_function::{flip, fold};
use crate::continuation::{Monitor, Verdict, changes, rests};

/// A doubled orbit whose halves differ by this share of what they did has met the orbit that it doubles.
const MEETING: f64 = 0.1;
/// Halves that differ by less than this are one: where branches meet, steps become short.
const NO_ASYMMETRY: f64 = 1e-3;
/// A multiplier 1 of an orbit whose halves differ by less than this, and ever less, is that of the meeting.
const CLOSING: f64 = 1e-2;

/// The monitors of smooth bifurcations of orbits with this many multipliers, known to this accuracy, and what tells the
/// others apart.
///
/// A doubled orbit may meet the one from which it branches: there both of its halves become one, and beyond, its branch
/// only runs back.
#[must_use]
pub fn monitors<'a, P: PeriodicPoint + 'a>(
    multipliers: usize,
    accuracy: f64,
) -> Vec<Monitor<'a, P>> {
    let branch_point = Monitor::new(Kind::BranchPoint, closed)
        .only_if(move |ends| alike(ends) && !turns(ends) && !stand(ends, accuracy))
        .judged(move |ends, at: &P| {
            // So near a meeting a multiplier is 1 but for its digits.
            let halves = at.asymmetry();
            let closes =
                halves < ends[0].asymmetry() || !ends.iter().any(|end| tells(*end, accuracy));
            Some(if halves <= CLOSING && closes {
                Verdict::Last(Kind::Flip)
            } else {
                Verdict::Special(Kind::BranchPoint)
            })
        });
    let turn = Monitor::new(Kind::Fold, P::slope)
        .only_if(move |ends| {
            let marginal = critical(ends) || unsure(ends);
            asymmetry(ends).is_finite() || marginal && !stand(ends, accuracy)
        })
        .steady_if(|ends| !asymmetry(ends).is_finite() && stays_off(ends))
        .judged(turn);
    let doubling = Monitor::new(Kind::Flip, opened).only_if(alike);
    let mut named = vec![branch_point, doubling, turn];
    for k in 0..multipliers {
        named.extend([torus(k), krein(k)]);
    }
    named
}

/// Where multiplier k, one of a pair, passes through the unit circle; where that is told only by its margin, off by as much
/// as it is not on it.
fn torus<'a, P: PeriodicPoint + 'a>(k: usize) -> Monitor<'a, P> {
    let crossing = move |p: &P| growths(p).crossing(k);
    Monitor::new(Kind::Torus, crossing)
        // Of what dies out within a period or grows as fast, its logarithm says more than enough.
        .steady_if(move |ends| rests(ends.map(|p| crossing(p).tanh())))
        .only_if(move |ends| {
            let growths = ends.map(growths);
            let real = critical(ends) || changes(opened(ends[0]), opened(ends[1]));
            Growths::may_cross(growths, k) && (Growths::may_turn(growths, k) || !real)
        })
        .judged(move |_, at| {
            let turn = growths(at).get(k)?.turn;
            (turn != 0.0).then_some(Verdict::Special(Kind::Torus))
        })
        .known_to(move |at| growths(at).get(k).map_or(0.0, |one| one.rate.abs()))
}

/// Where multiplier k and another one collide on the unit circle and leave it.
fn krein<'a, P: PeriodicPoint + 'a>(k: usize) -> Monitor<'a, P> {
    Monitor::new(Kind::Krein, move |p: &P| growths(p).collision(k))
        .only_if(move |ends| Growths::may_collide(ends.map(growths), k))
}

fn growths<P: PeriodicPoint>(point: &P) -> &Growths {
    &point.floquet().growths
}

fn opened<P: PeriodicPoint>(point: &P) -> f64 {
    flip(&point.floquet().known())
}

fn closed<P: PeriodicPoint>(point: &P) -> f64 {
    fold(&point.floquet().known())
}

fn turns<P: PeriodicPoint>([from, to]: [&P; 2]) -> bool {
    changes(from.slope(), to.slope())
}

/// Whether a multiplier passes through 1.
fn critical<P: PeriodicPoint>(ends: [&P; 2]) -> bool {
    let [from, to] = ends.map(closed);
    alike(ends) && changes(from, to)
}

/// Whether as many multipliers are known at both: one of which nothing is known any more passes through nothing.
fn alike<P: PeriodicPoint>(ends: [&P; 2]) -> bool {
    let [from, to] = ends.map(|end| end.floquet().known().len());
    from == to
}

/// Whether one is 1 at both, as far as its errors tell: where another is large, only the turn of r tells a fold.
fn unsure<P: PeriodicPoint>(ends: [&P; 2]) -> bool {
    ends.iter().all(|end| end.floquet().may_be_one())
}

/// Whether r stands still between two points at which a multiplier is 1, as far as errors tell: orbits there are a family,
/// and it is their errors that turn r or move the multiplier.
fn stand<P: PeriodicPoint>(ends: [&P; 2], accuracy: f64) -> bool {
    let [from, to] = ends;
    (to.r() - from.r()).abs() <= accuracy * to.r_scale() && unsure(ends)
}

/// Whether no multiplier is near 1 or comes near it between two points: where r turns, one is 1.
pub(super) fn stays_off<P: PeriodicPoint>(ends: [&P; 2]) -> bool {
    let certain = |end: &P| !end.floquet().may_be_one();
    ends.iter().all(|end| certain(end)) && rests(ends.map(closed))
}

/// Whether the multiplier of a doubled orbit differs from 1 by more than its error: next to the orbit that it doubles the
/// equations of both are satisfied so nearly everywhere between them that what is found is off by the accuracy over the
/// distance of the halves.
fn tells<P: PeriodicPoint>(point: &P, accuracy: f64) -> bool {
    closed(point).abs() * point.asymmetry() > accuracy
}

fn asymmetry<P: PeriodicPoint>([from, to]: [&P; 2]) -> f64 {
    from.asymmetry().max(to.asymmetry())
}

/// Where r turns: at a fold if a multiplier passes through 1, or where a doubled orbit meets the one from which it
/// branches. There both halves of the orbit become one, and a multiplier only touches 1, as far as its digits tell.
fn turn<P: PeriodicPoint>(ends: [&P; 2], at: &P) -> Option<Verdict> {
    let (critical, before) = (critical(ends), asymmetry(ends));
    let near = if critical {
        NO_ASYMMETRY
    } else {
        (MEETING * before).max(NO_ASYMMETRY)
    };
    if before.is_finite() && at.asymmetry() <= near {
        return Some(Verdict::Last(Kind::Flip));
    }
    let fold = critical || !before.is_finite() && unsure(ends);
    fold.then_some(Verdict::Special(Kind::Fold))
}

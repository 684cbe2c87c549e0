//! What happens between two neighbouring points of a branch, with bookkeeping.

use super::locate::zero;
use super::test_function::{flip, fold, is_torus, torus};
use super::watched::{Path, Spot, Watched};
use super::word_change::word_change;
use super::{Kind, Stability};

/// Halvings of a step after which a change stays unexplained.
const HALVINGS: u32 = 12;

/// Where a step is divided; the second where the number of unstable multipliers is not certain at the first.
const MIDDLES: [f64; 2] = [0.5, 0.4];

/// Distance between two changes of the event word, in units of the accuracy, below which they are one.
const SAME: f64 = 30.0;

/// A doubled orbit whose halves differ by this share of what they did has met the orbit that it doubles.
const MEETING: f64 = 0.1;

/// Halves that differ by less than this are one: where branches meet, steps become short.
const NO_ASYMMETRY: f64 = 1e-3;

/// A bifurcation that was found.
#[derive(Debug, Clone, PartialEq)]
pub struct Located<P> {
    /// Which.
    pub kind: Kind,
    /// The design variable there.
    pub r: f64,
    /// The orbit there, or the nearest on the side from which the branch came.
    pub point: P,
    /// Whether the branch meets another one there, from which it is a doubling, and only runs back beyond.
    pub meets: bool,
    /// r and number of unstable multipliers at the points between which it was found.
    pub sides: [(f64, usize); 2],
    share: f64,
}

impl<P> Located<P> {
    pub(super) fn at(kind: Kind, r: f64, point: P) -> Self {
        Self {
            kind,
            r,
            point,
            meets: false,
            sides: [(r, 0); 2],
            share: 1.0,
        }
    }

    fn between(kind: Kind, [from, to]: [&Spot<P>; 2], at: Spot<P>) -> Self
    where
        P: Watched,
    {
        let side = |spot: &Spot<P>| (spot.point.r(), spot.point.floquet().unstable);
        Self {
            kind,
            r: at.point.r(),
            meets: false,
            sides: [side(from), side(to)],
            share: at.share,
            point: at.point,
        }
    }

    /// Where a doubled orbit has become the one from which it branches.
    fn meeting(ends: [&Spot<P>; 2], at: Spot<P>) -> Self
    where
        P: Watched,
    {
        Self {
            meets: true,
            ..Self::between(Kind::Flip, ends, at)
        }
    }

    /// Which side of it a branch at `r` lies on: by how many multipliers the branch on which it was found
    /// is more unstable there than on the other side. `None` where that cannot be told.
    #[must_use]
    pub fn more_unstable_towards(&self, r: f64) -> Option<i64> {
        let [here, there] = self.unstable_from(r)?;
        let change = here as i64 - there as i64;
        (change != 0).then_some(change)
    }

    /// How many unstable multipliers a branch that leaves here has at `r`, as long as nothing else happens on it: the two
    /// branches exchange their stability, so that it has as many as the other one has across the crossing.
    /// `None` where that cannot be told.
    #[must_use]
    pub fn unstable_beside(&self, r: f64) -> Option<usize> {
        let [here, across] = self.unstable_from(r)?;
        (here.abs_diff(across) == 1).then_some(across)
    }

    /// The numbers of unstable multipliers on the side of `r` and on the other.
    fn unstable_from(&self, r: f64) -> Option<[usize; 2]> {
        let [from, to] = self.sides;
        let between = (from.0 - self.r) * (to.0 - self.r) < 0.0;
        let (here, there) = if (from.0 - self.r) * (r - self.r) > 0.0 {
            (from, to)
        } else {
            (to, from)
        };
        (between && r != self.r).then_some([here.1, there.1])
    }
}

/// A change in the number of unstable multipliers, or of the event word, with no bifurcation to explain it.
#[derive(Debug, Clone, PartialEq)]
pub struct Unexplained {
    /// The design variable before and after.
    pub between: [f64; 2],
    /// Number of unstable multipliers before and after.
    pub unstable: [usize; 2],
    /// Why it was not looked at more closely.
    pub reason: String,
}

/// All that was found on one step of a branch.
#[derive(Debug, Clone, PartialEq)]
pub struct Findings<P> {
    /// Bifurcations, in their order along the branch.
    pub located: Vec<Located<P>>,
    /// What they do not explain.
    pub unexplained: Vec<Unexplained>,
}

impl<P> Findings<P> {
    /// One bifurcation, and all is explained.
    #[must_use]
    pub fn of(located: Located<P>) -> Self {
        Self {
            located: vec![located],
            unexplained: Vec::new(),
        }
    }
}

/// Finds the bifurcations between two neighbouring points: by the signs of test functions and by the
/// event words; a step on which they do not account for the change of stability is halved.
pub fn detect<Q: Path>(
    path: &mut Q,
    from: &Q::Point,
    to: &Q::Point,
    accuracy: f64,
) -> Findings<Q::Point> {
    let mut hunt = Hunt {
        path,
        accuracy,
        found: Findings {
            located: Vec::new(),
            unexplained: Vec::new(),
        },
    };
    let spot = |share, point: &Q::Point| Spot {
        share,
        point: point.clone(),
    };
    hunt.step(&spot(0.0, from), &spot(1.0, to), HALVINGS);
    let located = &mut hunt.found.located;
    located.sort_by(|a, b| a.share.total_cmp(&b.share));
    // Events that switch together at one value of r do so in two steps for a tolerance.
    located.dedup_by(|b, a| {
        let distance = (b.r - a.r).abs();
        a.kind.jump().is_none()
            && b.kind.jump().is_none()
            && distance <= SAME * accuracy * a.r.abs()
    });
    hunt.found
}

/// A function of a point that changes sign at a bifurcation.
type TestFunction<P> = fn(&P) -> f64;

struct Hunt<'a, Q: Path> {
    path: &'a mut Q,
    accuracy: f64,
    found: Findings<Q::Point>,
}

impl<Q: Path> Hunt<'_, Q> {
    fn step(&mut self, from: &Spot<Q::Point>, to: &Spot<Q::Point>, halvings: u32) {
        if !from.point.same_word(&to.point) {
            return self.change(from, to, halvings);
        }
        let events = self.smooth(from, to);
        match events {
            // Beyond a meeting the branch only runs back.
            Ok(events) if events.iter().any(|event| event.meets) => {
                self.found.located.extend(events);
            }
            Ok(events) if accounts(&events, &from.point, &to.point) => {
                self.found.located.extend(events);
            }
            _ if halvings == 0 => self.give_up(from, to, "the step cannot be halved any more"),
            _ => self.halve(from, to, halvings - 1),
        }
    }

    fn halve(&mut self, from: &Spot<Q::Point>, to: &Spot<Q::Point>, halvings: u32) {
        match self.middle(from, to) {
            Ok(middle) => {
                self.step(from, &middle, halvings);
                self.step(&middle, to, halvings);
            }
            Err(error) => self.give_up(from, to, &error.to_string()),
        }
    }

    /// A point between two others at which the number of unstable multipliers is certain, if there is one: where it is not,
    /// every change would pass as explained.
    fn middle(
        &mut self,
        from: &Spot<Q::Point>,
        to: &Spot<Q::Point>,
    ) -> Result<Spot<Q::Point>, Q::Error> {
        let certain =
            |spot: &Spot<Q::Point>| spot.point.floquet().stability != Stability::Undecided;
        let mut divided = |part: f64| {
            let share = from.share + part * (to.share - from.share);
            let point = self.path.at(share)?;
            Ok(Spot { share, point })
        };
        let [first, second] = MIDDLES;
        let middle = divided(first)?;
        if certain(&middle) {
            return Ok(middle);
        }
        let beside: Result<_, Q::Error> = divided(second);
        Ok(beside.ok().filter(certain).unwrap_or(middle))
    }

    /// A step on which the word changes: up to the change, the change, and what lies beyond.
    fn change(&mut self, from: &Spot<Q::Point>, to: &Spot<Q::Point>, halvings: u32) {
        let change = word_change(self.path, from, to, self.accuracy);
        let (before, after) = (change.before, change.after);
        if before.share > from.share {
            self.step(from, &before, halvings);
        }
        if change.sharp {
            self.found.located.push(Located {
                r: 0.5 * (before.point.r() + after.point.r()),
                ..Located::between(change.kind, [&before, &after], before.clone())
            });
        } else {
            self.give_up(
                &before,
                &after,
                "the events change, and no orbit was found between",
            );
        }
        if after.share < to.share {
            self.step(&after, to, halvings);
        }
    }

    /// The smooth bifurcations that test functions show between two spots.
    fn smooth(
        &mut self,
        from: &Spot<Q::Point>,
        to: &Spot<Q::Point>,
    ) -> Result<Vec<Located<Q::Point>>, Q::Error> {
        let tests: [(Kind, TestFunction<Q::Point>); 3] = [
            (Kind::BranchPoint, |p| fold(&p.floquet().multipliers)),
            (Kind::Flip, |p| flip(&p.floquet().multipliers)),
            (Kind::Torus, |p| torus(&p.floquet().multipliers)),
        ];
        // A point may lie on the bifurcation itself: 0 has a sign like any number, so that one of the steps beside it sees it.
        let below = |test: TestFunction<Q::Point>| [from, to].map(|spot| test(&spot.point) < 0.0);
        let changes = |test| below(test)[0] != below(test)[1];
        let turns = changes(Q::Point::slope);
        let mut found = Vec::new();
        for (kind, test) in tests.into_iter().filter(|(_, test)| changes(*test)) {
            if kind == Kind::BranchPoint && turns {
                continue;
            }
            let at = zero(self.path, [from, to], test, self.accuracy)?;
            let halves = at.point.asymmetry();
            let closing = halves <= NO_ASYMMETRY && halves < from.point.asymmetry();
            if kind == Kind::BranchPoint && closing {
                // So near a meeting a multiplier is 1 but for its digits.
                found.push(Located::meeting([from, to], at));
            } else if kind != Kind::Torus || is_torus(&at.point.floquet().multipliers) {
                found.push(Located::between(kind, [from, to], at));
            }
        }
        if turns {
            let critical = changes(|p| fold(&p.floquet().multipliers));
            found.extend(self.turn([from, to], critical)?);
        }
        Ok(found)
    }

    /// Where r turns: at a fold if a multiplier passes through 1, or where a doubled orbit meets the one from which it
    /// branches. There both halves of the orbit become one, and a multiplier only touches 1, as far as its digits tell.
    fn turn(
        &mut self,
        ends: [&Spot<Q::Point>; 2],
        critical: bool,
    ) -> Result<Option<Located<Q::Point>>, Q::Error> {
        let [from, to] = ends.map(|spot| spot.point.asymmetry());
        let before = from.max(to);
        if !before.is_finite() && !critical {
            return Ok(None);
        }
        let at = zero(self.path, ends, Q::Point::slope, self.accuracy)?;
        let near = if critical {
            NO_ASYMMETRY
        } else {
            (MEETING * before).max(NO_ASYMMETRY)
        };
        if before.is_finite() && at.point.asymmetry() <= near {
            return Ok(Some(Located::meeting(ends, at)));
        }
        Ok(critical.then(|| Located::between(Kind::Fold, ends, at)))
    }

    fn give_up(&mut self, from: &Spot<Q::Point>, to: &Spot<Q::Point>, reason: &str) {
        let pair = [&from.point, &to.point];
        self.found.unexplained.push(Unexplained {
            between: pair.map(Watched::r),
            unstable: pair.map(|point| point.floquet().unstable),
            reason: reason.to_owned(),
        });
    }
}

/// Whether the bifurcations account for the change in the number of unstable multipliers; where that
/// number is not certain, they do.
fn accounts<P: Watched>(events: &[Located<P>], from: &P, to: &P) -> bool {
    let (from, to) = (from.floquet(), to.floquet());
    if [from, to]
        .map(|f| f.stability)
        .contains(&Stability::Undecided)
    {
        return true;
    }
    let change = to.unstable as i64 - from.unstable as i64;
    let mut sums = vec![0];
    let own = events.iter().filter(|event| !event.meets);
    for jump in own.filter_map(|event| event.kind.jump()) {
        sums = sums
            .iter()
            .flat_map(|sum| [sum - jump, sum + jump])
            .collect();
    }
    sums.contains(&change)
}

#[cfg(test)]
mod tests;

//! What happens between two neighbouring points of a branch, with bookkeeping.

mod account;
mod lost;

use std::cell::Cell;

pub(super) use account::explains;

use super::change::change;
use super::kind::Kind;
use super::located::{Findings, Located, Unexplained};
use super::margin;
use super::monitor::{Monitor, Verdict, changes, dips, rests};
use super::path::{Path, Spot, Watched};
use super::root::{DOUBT, zero};

/// Where a step is divided; the second where more directions are marginal at the first than at the ends.
const MIDDLES: [f64; 2] = [0.5, 0.4];
/// Halvings of a step after which a change stays unexplained.
const HALVINGS: u32 = 12;
/// Divisions of a step up to which each part of it is looked at in its middle.
const GLANCES: u32 = 3;
/// Changes of regime on one step beyond which it is given up: where two orbits lie in one place, each look may find the other, and
/// changes never end.
const CHANGES: usize = 50;
/// Sides of a change of regime, from each of which an orbit that is known to the accuracy comes to it.
const SIDES: f64 = 2.0;
/// Distance between two changes of regime, in units of the accuracy, below which they are one.
const ONE_CHANGE: f64 = 30.0;

/// Finds what happens between two neighbouring points: by the signs of monitors and by the regimes; a step on which
/// special points do not account for the change of stability is halved.
pub fn detect<Q: Path>(
    path: &mut Q,
    monitors: &[Monitor<'_, Q::Point>],
    [from, to]: [&Q::Point; 2],
    accuracy: f64,
) -> Findings<Q::Point> {
    let mut hunt = Hunt {
        path,
        monitors,
        accuracy,
        located: Vec::new(),
        unexplained: Vec::new(),
        bound: None,
        changes: 0,
    };
    hunt.step(&Spot::new(0.0, from), &Spot::new(1.0, to), HALVINGS);
    hunt.findings()
}

struct Hunt<'a, 'm, Q: Path> {
    path: &'a mut Q,
    monitors: &'a [Monitor<'m, Q::Point>],
    accuracy: f64,
    located: Vec<Located<Q::Point>>,
    unexplained: Vec<Unexplained>,
    bound: Option<Spot<Q::Point>>,
    /// Changes of regime that were met.
    changes: usize,
}

/// What the monitors show on one stretch.
struct Events<P> {
    located: Vec<Located<P>>,
    bound: Option<Spot<P>>,
}

impl<Q: Path> Hunt<'_, '_, Q> {
    fn findings(self) -> Findings<Q::Point> {
        let (mut located, accuracy) = (self.located, self.accuracy);
        located.sort_by(|a, b| a.share.total_cmp(&b.share));
        // Events that switch together at one value of r do so in two steps for a tolerance, or as far as their errors tell.
        located.dedup_by(|b, a| {
            let distance = (b.r - a.r).abs();
            let close = distance <= ONE_CHANGE * accuracy * a.point.r_size();
            a.abrupt && b.abrupt && (close || distance <= a.error + b.error)
        });
        if let Some(bound) = &self.bound {
            located.retain(|event| event.share <= bound.share);
        }
        let last = located.iter().position(|event| event.last);
        located.truncate(last.map_or(located.len(), |last| last + 1));
        Findings {
            located,
            unexplained: self.unexplained,
            bound: self.bound.map(|spot| spot.point),
        }
    }

    fn step(&mut self, from: &Spot<Q::Point>, to: &Spot<Q::Point>, halvings: u32) {
        if self.parts(from, to) {
            return self.change(from, to, halvings);
        }
        match self.events([from, to]) {
            Ok(Some(events))
                if explains(&events.located, &from.point, &to.point)
                    && !self.hides(from, to, halvings) =>
            {
                self.located.extend(events.located);
                self.bound = self.bound.take().or(events.bound);
            }
            _ if halvings == 0 => self.give_up(from, to, "the step cannot be halved any more"),
            _ => self.halve(from, to, halvings - 1),
        }
    }

    /// Whether the regime changes between two spots: what is so short that it may be an error is none, unless it begins or
    /// ends at a border, which would be lost where it has grown by the next point.
    fn parts(&mut self, from: &Spot<Q::Point>, to: &Spot<Q::Point>) -> bool {
        let ends = [&from.point, &to.point];
        let border = |path: &mut Q| path.border(ends).is_some();
        // Around a corner, too, what is short is what the branch turns for.
        let corner = |path: &mut Q| path.corner([from.share, to.share]).is_some();
        !ends[0].same_regime(ends[1])
            && (!ends[0].seems_in_regime_of(ends[1]) || corner(self.path) || border(self.path))
    }

    /// Whether a function that has one sign at both ends may have the other one between them, or the regime may change and
    /// change back: as far as a third point tells, and the parabolas through all three.
    fn hides(&mut self, from: &Spot<Q::Point>, to: &Spot<Q::Point>, halvings: u32) -> bool {
        let ends = [&from.point, &to.point];
        if halvings + GLANCES <= HALVINGS || self.rests(ends) {
            return false;
        }
        let Some(middle) = self.path.glance(0.5 * (from.share + to.share)) else {
            return false;
        };
        let dips = |monitor: &Monitor<'_, Q::Point>| {
            let [a, b] = ends.map(&monitor.test);
            !changes(a, b) && dips([a, (monitor.test)(&middle), b])
        };
        !middle.seems_in_regime_of(ends[0])
            || self.monitors.iter().any(dips)
            || margin::at_all([ends[0], &middle, ends[1]]).any(self::dips)
    }

    /// Whether nothing happens there and back between two points, as far as they tell: where regimes may part, which
    /// multipliers need not show, only if no monitor changes at all.
    fn rests(&self, ends: [&Q::Point; 2]) -> bool {
        let mut all = self.monitors.iter();
        let parts = ends.iter().any(|end| !end.margins(end).is_empty());
        if parts {
            all.all(|monitor| rests(ends.map(&monitor.test)))
        } else {
            all.all(|monitor| monitor.rests(ends))
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

    /// A point between two others at which no more directions are marginal, if there is one: where they are, every change
    /// would pass as explained.
    fn middle(
        &mut self,
        from: &Spot<Q::Point>,
        to: &Spot<Q::Point>,
    ) -> Result<Spot<Q::Point>, Q::Error> {
        let mut divided = |part: f64| {
            let share = from.share + part * (to.share - from.share);
            let mut point = self.path.at(share)?;
            // What is marginal there has the sign with which it came, or nothing would pass.
            point.inherit(&from.point);
            Ok(Spot { share, point })
        };
        let [first, second] = MIDDLES;
        let middle = divided(first)?;
        let most = from.point.marginal().min(to.point.marginal());
        let certain = |spot: &Spot<Q::Point>| spot.point.marginal() <= most;
        if certain(&middle) {
            return Ok(middle);
        }
        let beside: Result<_, Q::Error> = divided(second);
        Ok(beside.ok().filter(certain).unwrap_or(middle))
    }

    /// A step on which the regime changes: up to the change, the change, and what lies beyond.
    fn change(&mut self, from: &Spot<Q::Point>, to: &Spot<Q::Point>, halvings: u32) {
        self.changes += 1;
        if self.changes > CHANGES {
            return self.give_up(from, to, "the events change too often");
        }
        let (accuracy, monitors) = (self.accuracy, self.monitors);
        let mut found = change(self.path, [from, to], accuracy);
        let beside = found.beside(self.path, |ends| passes(monitors, ends));
        let [before, after] = found.nearest();
        let [low, high] = beside
            .as_ref()
            .map_or([before, after], |near| near.each_ref());
        if low.share > from.share {
            self.step(from, low, halvings);
        }
        // Where the branch turns at once, neither end need be near it.
        let corner = self.path.corner([before.share, after.share]);
        if let Some(border) = &found.border {
            self.located.push(Located {
                left: border.points[1].slope(),
                last: border.last,
                abrupt: true,
                error: border.error,
                ..Located::between(border.kind, [before, after], before.clone())
            });
            if border.last {
                return;
            }
        } else if found.is_sharp() || corner.is_some() {
            // Where two events meet, no other lies between them.
            let (kind, at, (r, error)) = match &found.meeting {
                Some((at, error)) => (Kind::VanishingSegment, at, (at.point.r(), *error)),
                None => {
                    let kind = self.path.name([&before.point, &after.point]);
                    let least = DOUBT * SIDES * accuracy;
                    let at =
                        corner.map(|(r, error)| (r, DOUBT * error + least * before.point.r_size()));
                    (kind, before, at.unwrap_or_else(|| found.within(least)))
                }
            };
            self.located.push(Located {
                r,
                error,
                abrupt: true,
                ..Located::between(kind, [before, after], at.clone())
            });
        } else {
            let reason = "the events change, and no border was found between";
            self.give_up(before, after, reason);
        }
        if high.share < to.share {
            self.step(high, to, halvings);
        }
    }

    /// What the monitors show between two spots of one regime; `None` where it is left on the way, as functions may change
    /// their signs there by a jump.
    fn events(&mut self, ends: [&Spot<Q::Point>; 2]) -> Result<Option<Events<Q::Point>>, Q::Error> {
        let points = ends.map(|spot| &spot.point);
        let (mut located, mut bound) = (Vec::new(), None);
        for monitor in self.monitors {
            if !monitor.crosses(points) {
                continue;
            }
            let left = Cell::new(false);
            let test = |point: &Q::Point| {
                left.set(left.get() || !point.seems_in_regime_of(points[0]));
                (monitor.test)(point)
            };
            let mut at = match zero(self.path, ends, test, self.accuracy) {
                Ok(at) => at,
                Err(error) => {
                    located.push(self.lost(ends).ok_or(error)?);
                    continue;
                }
            };
            if left.get() {
                return Ok(None);
            }
            let (kind, last) = match monitor.verdict(points, &mut at.spot.point) {
                Some(Verdict::Special(kind)) => (kind, false),
                Some(Verdict::Last(kind)) => (kind, true),
                Some(Verdict::Bound) => {
                    bound = Some(at.spot);
                    continue;
                }
                None => continue,
            };
            // At a zero of the slope itself, what r is known to is told beside it.
            let size = points
                .iter()
                .map(|point| point.r_size())
                .fold(0.0, f64::max);
            let [error, lasting] = at.errors(self.path, monitor, (self.accuracy, size));
            located.push(Located {
                last,
                error,
                lasting,
                ..Located::between(kind, ends, at.spot)
            });
        }
        Ok(Some(Events { located, bound }))
    }

    fn give_up(&mut self, from: &Spot<Q::Point>, to: &Spot<Q::Point>, reason: &str) {
        let ends = [&from.point, &to.point];
        self.unexplained.push(Unexplained::between(ends, reason));
    }
}

/// Whether something happens between two points of one regime, as far as they tell.
fn passes<P: Watched>(monitors: &[Monitor<'_, P>], ends: [&P; 2]) -> bool {
    let crosses = monitors.iter().any(|monitor| monitor.crosses(ends));
    crosses || ends[0].unstable() != ends[1].unstable()
}

#[cfg(test)]
mod tests;

//! One branch of periodic orbits, followed in one direction.

use super::branch::{ENDLESS, Ended, Watch};
use super::case::Along;
use super::orbit::OrbitRecord;
use super::sought::Sought;
use crate::bifurcation::{Located, Unexplained, Watched, detect, explain, reach};
use crate::continuation::Ending;
use crate::field::Work;
use crate::shooting::{Guess, Orbit, OrbitBranch, converge};

/// Orbits after which a branch may have come round.
const ROUND: usize = 3;
/// Two orbits at one r are one if they differ by this share of their extents at most.
pub(super) const SAME: f64 = 1e-5;

/// A branch as far as it was followed in one direction, or in both.
pub(super) struct Stretch {
    pub(super) points: Vec<OrbitRecord>,
    pub(super) located: Vec<Located<Orbit>>,
    /// How many of the points precede each of the located ones.
    pub(super) after: Vec<usize>,
    pub(super) ended: Ended,
    pub(super) began: Option<Ended>,
}

impl Stretch {
    /// Whether it would have gone on if it had not been interrupted.
    pub(super) fn is_interrupted(&self) -> bool {
        let mut ends = self.began.iter().chain([&self.ended]);
        ends.any(Ended::is_interrupted)
    }

    /// The same branch with what lies behind its beginning; `shared` tells whether both begin with one orbit.
    pub(super) fn behind(self, back: Self, shared: bool) -> Self {
        let (mut points, count) = (back.points, back.after.iter().rev());
        let turned = points.len();
        let mut after: Vec<usize> = count.map(|after| turned.saturating_sub(*after)).collect();
        if shared && !points.is_empty() {
            points.remove(0);
        }
        points.reverse();
        after.extend(self.after.iter().map(|after| after + points.len()));
        points.extend(self.points);
        let mut located = back.located;
        located.reverse();
        located.extend(self.located);
        Self {
            points,
            located,
            after,
            ended: self.ended,
            began: Some(back.ended),
        }
    }
}

/// A branch being followed.
struct Following<'a> {
    sought: &'a Sought<'a>,
    along: Along,
    branch: OrbitBranch,
    orbits: Vec<Orbit>,
    points: Vec<OrbitRecord>,
    located: Vec<Located<Orbit>>,
    after: Vec<usize>,
    unexplained: Option<Unexplained>,
    /// Work on steps that were taken back.
    wasted: Work,
}

/// What to do after a step.
enum Verdict {
    GoOn,
    /// It was taken back.
    Again,
    End(Ended),
}

/// Follows a branch to its end; `before` is work that its first point has cost besides.
pub(super) fn follow(
    sought: &Sought<'_>,
    along: Along,
    branch: OrbitBranch,
    before: Work,
    watch: Watch<'_>,
) -> Stretch {
    let mut following = Following {
        sought,
        along,
        branch,
        orbits: Vec::new(),
        points: Vec::new(),
        located: Vec::new(),
        after: Vec::new(),
        unexplained: None,
        wasted: Work::default(),
    };
    let ended = following.run(before, watch);
    let unexplained = following.unexplained.filter(|_| !ended.is_interrupted());
    let unexplained = unexplained.map(|change| Unexplained {
        between: change.between.map(|r| along.value(r)),
        ..change
    });
    Stretch {
        points: following.points,
        located: following.located,
        after: following.after,
        ended: unexplained.map_or(ended, |change| Ended::unexplained(&change)),
        began: None,
    }
}

impl Following<'_> {
    fn run(&mut self, before: Work, watch: Watch<'_>) -> Ended {
        while let Some(orbit) = self.branch.next() {
            let mut point = self.sought.record(&orbit);
            if self.points.is_empty() {
                point.work += before;
            }
            match self.examine(&orbit, &mut point) {
                Verdict::GoOn => {}
                Verdict::Again => continue,
                Verdict::End(ended) => return ended,
            }
            let verdict = watch(&point);
            let first = self.points.first().map_or(point.period, |p| p.period);
            let endless = point.period > ENDLESS * first;
            self.points.push(point);
            self.orbits.push(orbit);
            if endless {
                return Ended::endless();
            }
            if verdict.is_break() {
                return Ended::interrupted();
            }
        }
        let reason = match self.branch.ending() {
            Some(Ending::StepTooSmall(_) | Ending::Creeping(_)) => {
                explain(&self.orbits, self.sought.search.accuracy)
            }
            _ => None,
        };
        match reason {
            Some(reason) => self.end(reason),
            None => self
                .branch
                .ending()
                .map_or_else(Ended::endless, Ended::from),
        }
    }

    /// Looks for bifurcations on the way to `orbit`, and for the end of the branch before it.
    fn examine(&mut self, orbit: &Orbit, point: &mut OrbitRecord) -> Verdict {
        let (Some(mut path), Some(before)) = (self.branch.path(), self.orbits.last()) else {
            return Verdict::GoOn;
        };
        if orbit.asymmetry() <= SAME {
            return self.undoubled(orbit, point.work);
        }
        let accuracy = self.sought.search.accuracy;
        let mut findings = detect(&mut path, before, orbit, accuracy);
        for found in &mut findings.located {
            self.sought.tell_symmetry(found);
        }
        if !findings.unexplained.is_empty() {
            self.wasted += path.work();
            self.wasted += point.work;
            // Beyond a graze, what was found is not the same motion any more.
            if let Some(reason) = explain(&self.orbits, accuracy) {
                return Verdict::End(self.end(reason));
            }
            if self.branch.retract() {
                return Verdict::Again;
            }
        }
        let home = self.orbits.first().filter(|_| self.orbits.len() > ROUND);
        let round = home.and_then(|home| {
            let back = reach(&mut path, [before, orbit], home.r, accuracy).ok()??;
            home.coincides(&back, SAME).then_some(home.r)
        });
        point.work += path.work();
        point.work += std::mem::take(&mut self.wasted);
        let meeting = findings.located.iter().position(|event| event.meets);
        let count = meeting.map_or(findings.located.len(), |last| last + 1);
        self.located
            .extend(findings.located.into_iter().take(count));
        self.after.resize(self.located.len(), self.points.len());
        if let (Some(_), Some(met)) = (meeting, self.located.last_mut()) {
            undouble(self.sought, met);
            return Verdict::End(Ended::meets(self.along.value(met.r)));
        }
        let first = findings.unexplained.into_iter().next();
        self.unexplained = self.unexplained.take().or(first);
        round.map_or(Verdict::GoOn, |r| {
            Verdict::End(Ended::closed(self.along.value(r)))
        })
    }

    /// What was found is a shorter orbit, gone around twice: the step went past where the branch meets the one from which
    /// it doubles.
    fn undoubled(&mut self, orbit: &Orbit, work: Work) -> Verdict {
        self.wasted += work;
        if self.branch.retract() {
            Verdict::Again
        } else {
            Verdict::End(Ended::falls_back(self.along.value(orbit.r)))
        }
    }

    fn end(&mut self, reason: Located<Orbit>) -> Ended {
        let ended = Ended::at(reason.kind, self.along.value(reason.r));
        self.located.push(reason);
        self.after.push(self.points.len());
        ended
    }
}

/// Replaces a doubled orbit that has met the one from which it branches by that one.
fn undouble(sought: &Sought<'_>, met: &mut Located<Orbit>) {
    let orbit = &met.point;
    let guess = Guess {
        place: orbit.place.clone(),
        period: 0.5 * orbit.period,
        magnitude: orbit.magnitude(),
    };
    match converge(&sought.family, met.r, &guess, &sought.search) {
        Ok(single) if single.period < 0.75 * orbit.period => met.point = single,
        // As far as it is known, the doubled orbit is that orbit twice.
        _ => {
            met.point.period *= 0.5;
            let half = met.point.section.len() / 2;
            met.point.section.truncate(half);
            met.point.period_count = half;
        }
    }
}

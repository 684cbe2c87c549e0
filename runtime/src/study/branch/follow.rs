//! One branch of periodic orbits, followed in one direction.

use super::meeting::undouble;
use super::record::Watch;
use crate::continuation::{Ending, Located, walk};
use crate::field::Work;
use crate::shooting::{Orbit, OrbitBranch};
use crate::study::ended::Ended;
use crate::study::orbit::OrbitRecord;
use crate::study::orbit::Sought;
use crate::study::question::Along;

/// A branch as far as it was followed in one direction, or in both.
pub(in crate::study) struct Stretch {
    pub(in crate::study) points: Vec<OrbitRecord>,
    pub(in crate::study) located: Vec<Located<Orbit>>,
    pub(in crate::study) ended: Ended,
    pub(in crate::study) began: Option<Ended>,
}

impl Stretch {
    /// Whether it would have gone on if it had not been interrupted.
    pub(in crate::study) fn is_interrupted(&self) -> bool {
        let mut ends = self.began.iter().chain([&self.ended]);
        ends.any(Ended::is_interrupted)
    }

    /// The same branch with what lies behind its beginning; `shared` tells whether both begin with one orbit.
    pub(in crate::study) fn behind(self, back: Self, shared: bool) -> Self {
        let (mut points, mut located) = (back.points, back.located);
        located.reverse();
        for found in &mut located {
            found.after = points.len().saturating_sub(found.after);
        }
        if shared && !points.is_empty() {
            points.remove(0);
        }
        points.reverse();
        located.extend(self.located.into_iter().map(|mut found| {
            found.after += points.len();
            found
        }));
        points.extend(self.points);
        Self {
            points,
            located,
            ended: self.ended,
            began: Some(back.ended),
        }
    }
}

/// Follows a branch to its end; `before` is work that its first point has cost besides.
pub(in crate::study) fn follow(
    sought: &Sought<'_>,
    along: Along,
    mut branch: OrbitBranch,
    before: Work,
    watch: Watch<'_>,
) -> Stretch {
    let (mut points, mut before) = (Vec::new(), Some(before));
    let mut walked = walk(&mut branch, &mut |orbit| {
        let mut point = sought.record(orbit);
        point.work += before.take().unwrap_or_default();
        let verdict = watch(&point);
        points.push(point);
        verdict
    });
    let last = walked.points.last().map(|last| last.r);
    if let (Ending::Meets(kind, r), Some(met)) = (&mut walked.ending, walked.located.last_mut()) {
        undouble(sought, met, last);
        (*kind, *r) = (met.kind, met.r);
    }
    Stretch {
        points,
        located: walked.located,
        ended: Ended::of(&walked.ending, along, last),
        began: None,
    }
}

//! The branches on which the motions lie that starts have found.

use super::passes::{Passes, SAME};
use super::record::{Attractor, AttractorsRecord, Class, Survey};
use crate::continuation::Kind;
use crate::shooting::Orbit;
use crate::study::branch::{BranchRecord, Watch};
use crate::study::error::StudyError;
use crate::study::orbit::Sought;
use crate::study::question::{Along, Beginning, Case, Switch};
use crate::study::system::System;

/// A motion among those that starts have found.
#[derive(Debug, Clone, PartialEq)]
pub struct Spot {
    /// The design variable there.
    pub r: f64,
    /// Its place among the motions found there, or, of a saddle, among the edges.
    pub place: usize,
    /// Whether it is a saddle on an edge.
    pub saddle: bool,
}

/// A branch on which motions lie that starts have found, followed both ways over the range of the design variable.
#[derive(Debug, Clone, PartialEq)]
pub struct Followed {
    /// The branch; it begins at the first of the motions.
    pub branch: BranchRecord,
    /// The motions.
    pub motions: Vec<Spot>,
}

/// All branches on which periodic motions lie that starts have found.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FollowedRecord {
    /// Each of them once.
    pub branches: Vec<Followed>,
    /// Motions that could not be followed, with the reason.
    pub failed: Vec<(Spot, String)>,
}

impl Followed {
    /// Whether it is an isola: it comes back to its beginning, and no branch crosses it.
    #[must_use]
    pub fn is_isola(&self) -> bool {
        let crossed = |kind| matches!(kind, Kind::BranchPoint | Kind::SymmetryBreaking);
        self.branch.ended.is_closed() && !self.branch.special.iter().any(|one| crossed(one.kind))
    }

    /// The least and the largest value of the design variable on it.
    #[must_use]
    pub fn span(&self) -> [f64; 2] {
        let points = self.branch.points.iter().filter_map(|point| point.r);
        let all = points.chain(self.branch.special.iter().map(|one| one.r));
        all.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], r| {
            [low.min(r), high.max(r)]
        })
    }
}

impl FollowedRecord {
    /// Whether it would have gone on if it had not been interrupted.
    #[must_use]
    pub fn is_interrupted(&self) -> bool {
        self.branches.iter().any(|one| one.branch.is_interrupted())
    }
}

impl System {
    /// The branches of the periodic motions of `record`, which was found along the design variable of the case: each is followed
    /// both ways over the whole range, once, however many of the motions lie on it. `watch` sees each orbit as it is found,
    /// and may end all there.
    ///
    /// # Errors
    /// The case cannot be asked, or nothing is followed.
    pub fn followed_watched(
        &self,
        case: &Case,
        record: &AttractorsRecord,
        watch: Watch<'_>,
    ) -> Result<FollowedRecord, StudyError> {
        self.check(case)?;
        let along = case.along.ok_or(StudyError::NothingToFollow)?;
        let mut found = FollowedRecord::default();
        for survey in &record.surveys {
            for (spot, motion) in periodic(survey) {
                let case = beginning(case, along, spot.r, motion);
                if let Err(error) = self.follow(&case, spot.clone(), &mut found, watch) {
                    found.failed.push((spot, error.to_string()));
                }
                if found.is_interrupted() {
                    return Ok(found);
                }
            }
        }
        Ok(found)
    }

    /// Puts a motion onto the branch on which it lies, a new one if it lies on none that is known.
    fn follow(
        &self,
        case: &Case,
        spot: Spot,
        found: &mut FollowedRecord,
        watch: Watch<'_>,
    ) -> Result<(), StudyError> {
        let sought = self.sought(case)?;
        let along = case.along.ok_or(StudyError::NothingToFollow)?;
        let r = Along {
            from: spot.r,
            ..along
        };
        let orbit = sought.orbit(r.span().0)?;
        let mut known = found.branches.iter_mut();
        match known.find(|one| sought.lies(&orbit, spot.r, &one.branch)) {
            Some(known) => known.motions.push(spot),
            None => found.branches.push(Followed {
                branch: self.branch_watched(case, watch)?,
                motions: vec![spot],
            }),
        }
        Ok(())
    }
}

impl Sought<'_> {
    /// Whether an orbit at this value of the design variable lies on a branch.
    fn lies(&self, orbit: &Orbit, r: f64, branch: &BranchRecord) -> bool {
        let mut guesses = Passes::of(branch).near(orbit, r).into_iter();
        guesses.any(|guess| {
            let found = self.from(guess, orbit.r);
            found.is_ok_and(|one| orbit.coincides(&one, SAME))
        })
    }
}

/// The periodic motions of a survey, with those on edges.
fn periodic(survey: &Survey) -> impl Iterator<Item = (Spot, &Attractor)> {
    let found = survey.found.iter().map(|found| &found.attractor);
    let saddles = survey.edges.iter().map(|edge| &edge.saddle);
    let number = |saddle| move |(place, motion)| (place, saddle, motion);
    let all = found.enumerate().map(number(false));
    let all = all.chain(saddles.enumerate().map(number(true)));
    let periodic = |one: &Attractor| {
        one.period.is_some() && !one.slides && matches!(one.class, Class::Orbit | Class::Running)
    };
    all.filter_map(move |(place, saddle, motion)| {
        let r = survey.r?;
        periodic(motion).then_some((Spot { r, place, saddle }, motion))
    })
}

/// The case of the branch that goes both ways from a motion.
fn beginning(case: &Case, along: Along, r: f64, motion: &Attractor) -> Case {
    // From the end of its range a branch goes one way only.
    let along = match r == along.to {
        true => Along {
            from: along.to,
            to: along.from,
            ..along
        },
        false => along,
    };
    Case {
        along: Some(along),
        start: Some(motion.state.clone()),
        period: motion.period,
        beginning: Beginning::At(r),
        switch: Switch::default(),
        ..case.at(r)
    }
}

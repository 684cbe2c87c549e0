//! The motions that starts have found, put onto branches: each branch is followed once, however many lie on it.

use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};

use super::followed::{Followed, FollowedRecord, Spot};
use super::passes::Passes;
use super::record::{Attractor, AttractorsRecord, Class, Survey};
use crate::shooting::{Orbit, SAME_ORBIT};
use crate::study::branch::BranchRecord;
use crate::study::error::StudyError;
use crate::study::orbit::{OrbitRecord, Sought};
use crate::study::question::{Along, Beginning, Case, Switch};
use crate::study::system::System;
use crate::study::work::parallel_on;

/// Told of each orbit as it is found, from any thread; a break ends all there.
pub(in crate::study) type Told<'a> = &'a mut (dyn FnMut(&OrbitRecord) -> ControlFlow<()> + Send);

/// A motion that lies on no branch yet.
struct Motion {
    spot: Spot,
    case: Case,
    orbit: Orbit,
}

impl System {
    /// The branches of the periodic motions of `record`, which was found along the design variable of the case: each is followed
    /// both ways over the whole range, once, however many of the motions lie on it. Motions of one value are followed side
    /// by side on so many threads, or on all cores; nothing depends on how many. `watch` sees each orbit as it is found,
    /// and may end all there.
    ///
    /// # Errors
    /// The case cannot be asked, or nothing is followed.
    pub fn followed_watched(
        &self,
        case: &Case,
        record: &AttractorsRecord,
        threads: Option<usize>,
        watch: Told<'_>,
    ) -> Result<FollowedRecord, StudyError> {
        self.check(case)?;
        let along = case.along.ok_or(StudyError::NothingToFollow)?;
        let mut found = FollowedRecord::default();
        let mut left = self.motions((case, along), record, threads, &mut found);
        let watch = Mutex::new(watch);
        while !left.is_empty() && !found.is_interrupted() {
            let (wave, rest) = parted(left);
            let known = found.branches.len();
            self.follow(wave, threads, &watch, &mut found);
            let new = &mut found.branches[known..];
            left = self.recognise(rest, threads, new);
        }
        found.sort();
        Ok(found)
    }

    /// The periodic motions with their orbits; those without are told of as failed.
    fn motions(
        &self,
        (case, along): (&Case, Along),
        record: &AttractorsRecord,
        threads: Option<usize>,
        found: &mut FollowedRecord,
    ) -> Vec<Motion> {
        let all = record.surveys.iter().flat_map(periodic);
        let all: Vec<(Spot, Case)> = all
            .map(|(spot, motion)| {
                let case = beginning(case, along, spot.r, motion);
                (spot, case)
            })
            .collect();
        let orbits = parallel_on(threads, &all, |(spot, case)| {
            let from = spot.r;
            let orbit = self.sought(case)?.orbit(Along { from, ..along }.span().0)?;
            Ok::<_, StudyError>(orbit)
        });
        let motion = |((spot, case), orbit): ((Spot, Case), Result<Orbit, StudyError>)| match orbit
        {
            Ok(orbit) => Some(Motion { spot, case, orbit }),
            Err(error) => {
                found.failed.push((spot, error.to_string()));
                None
            }
        };
        all.into_iter().zip(orbits).filter_map(motion).collect()
    }

    /// Follows motions of one value side by side; of those that lie on one branch, the first is followed.
    fn follow(
        &self,
        wave: Vec<Motion>,
        threads: Option<usize>,
        watch: &Mutex<Told<'_>>,
        found: &mut FollowedRecord,
    ) {
        let branches = parallel_on(threads, &wave, |one| {
            self.branch_through(&one.case, &one.orbit, &mut |orbit| {
                let mut watch = watch.lock().unwrap_or_else(PoisonError::into_inner);
                watch(orbit)
            })
        });
        let known = found.branches.len();
        for (motion, branch) in wave.into_iter().zip(branches) {
            let new = &mut found.branches[known..];
            match (self.place_of(&motion, new), branch) {
                (Some(place), _) => new[place].motions.push(motion.spot),
                (None, Ok(branch)) => found.branches.push(Followed {
                    branch,
                    motions: vec![motion.spot],
                }),
                (None, Err(error)) => found.failed.push((motion.spot, error.to_string())),
            }
        }
    }

    /// Puts motions onto the branches on which they lie; what is left of them.
    fn recognise(
        &self,
        all: Vec<Motion>,
        threads: Option<usize>,
        branches: &mut [Followed],
    ) -> Vec<Motion> {
        let places = parallel_on(threads, &all, |motion| self.place_of(motion, branches));
        let left = |(motion, place): (Motion, Option<usize>)| match place {
            Some(place) => {
                branches[place].motions.push(motion.spot);
                None
            }
            None => Some(motion),
        };
        all.into_iter().zip(places).filter_map(left).collect()
    }

    /// The first of these branches on which a motion lies.
    fn place_of(&self, motion: &Motion, branches: &[Followed]) -> Option<usize> {
        let sought = self.sought(&motion.case).ok()?;
        let lies = |one: &Followed| sought.lies(&motion.orbit, motion.spot.r, &one.branch);
        branches.iter().position(lies)
    }
}

/// The motions of the value that has most of them, the first of such, and all others.
fn parted(all: Vec<Motion>) -> (Vec<Motion>, Vec<Motion>) {
    let count = |r: f64| all.iter().filter(|one| one.spot.r == r).count();
    let most = all.iter().map(|one| count(one.spot.r)).max().unwrap_or(0);
    let first = all.iter().map(|one| one.spot.r).find(|r| count(*r) == most);
    all.into_iter().partition(|one| Some(one.spot.r) == first)
}

impl Sought<'_> {
    /// Whether an orbit at this value of the design variable lies on a branch.
    fn lies(&self, orbit: &Orbit, r: f64, branch: &BranchRecord) -> bool {
        let mut guesses = Passes::of(branch).near(orbit, r).into_iter();
        guesses.any(|guess| {
            let found = self.from(guess, orbit.r);
            found.is_ok_and(|one| orbit.coincides(&one, SAME_ORBIT))
        })
    }
}

/// The periodic motions of a survey, with those that draw nothing in.
fn periodic(survey: &Survey) -> impl Iterator<Item = (Spot, &Attractor)> {
    let found = survey.found.iter().map(|found| &found.attractor);
    let saddles = survey.saddles().map(|(_, saddle)| saddle);
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
        modes: motion.modes.clone(),
        period: motion.period,
        beginning: Beginning::At(r),
        switch: Switch::default(),
        ..case.at(r)
    }
}

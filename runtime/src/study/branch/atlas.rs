//! A branch of orbits with those that leave it, and those that leave them.

use super::follow::{Stretch, follow};
use super::record::{BranchRecord, Watch};
use super::special::{Special, numbered};
use crate::continuation::{Kind, Located, Settings, Watched};
use crate::field::Work;
use crate::shooting::{Orbit, OrbitBranch, OrbitError, SwitchError};
use crate::study::error::StudyError;
use crate::study::orbit::Sought;
use crate::study::question::{Along, Beginning, Case};
use crate::study::system::System;

type Here = Located<Orbit>;

/// A Hopf point of an equilibrium.
pub(in crate::study) struct Hopf {
    /// The design variable, as the family counts it.
    r: f64,
    /// The equilibrium.
    state: Vec<f64>,
    /// The period of the smallest orbits.
    period: f64,
}

/// Errors of a flip by which a doubled orbit is aside of it for certain, and orbits among which one is looked for that is.
const CERTAIN: f64 = 3.0;
const LOOKED: usize = 20;
/// Largest relative distance in r of one special point that is located on two branches.
const SAME_R: f64 = 1e-4;
/// Largest relative difference of the two orbits there: it goes with the root of their distance in r.
const SAME_ORBIT: f64 = 2e-2;

impl System {
    /// The branch of orbits along the design variable of the case; `watch` sees each point as it is found, and may end
    /// the branch there.
    ///
    /// # Errors
    /// There is no orbit to begin with.
    pub fn branch_watched(
        &self,
        case: &Case,
        watch: Watch<'_>,
    ) -> Result<BranchRecord, StudyError> {
        self.check(case)?;
        let along = case.along.ok_or(StudyError::NothingToFollow)?;
        let hopf = self.hopf(case, along)?;
        self.sought(case)?.branch(along, hopf, watch)
    }

    /// The branch along the design variable of the case through this orbit, where the case begins.
    pub(in crate::study) fn branch_through(
        &self,
        case: &Case,
        orbit: &Orbit,
        watch: Watch<'_>,
    ) -> Result<BranchRecord, StudyError> {
        let along = case.along.ok_or(StudyError::NothingToFollow)?;
        let sought = self.sought(case)?;
        let mut atlas = sought.atlas(along, watch);
        let stretch = atlas.through(orbit)?;
        Ok(atlas.record(stretch, None, case.switch.depth))
    }

    /// The Hopf point at which the branch of a case begins, if it begins at one.
    pub(in crate::study) fn hopf(
        &self,
        case: &Case,
        along: Along,
    ) -> Result<Option<Hopf>, StudyError> {
        if case.beginning != Beginning::Hopf {
            return Ok(None);
        }
        let branch = self.equilibria_along(case)?;
        let point = branch.special.iter().find_map(|point| {
            let from = point.r;
            Some(Hopf {
                r: Along { from, ..along }.span().0,
                state: point.state.clone(),
                period: point.period?,
            })
        });
        point.map(Some).ok_or(StudyError::NoHopf)
    }
}

impl Sought<'_> {
    /// Follows the orbit where `along` begins, and the branches that leave it as far as the case asks;
    /// `watch` sees each point as it is found, and may end all of them there.
    fn branch(
        &self,
        along: Along,
        hopf: Option<Hopf>,
        watch: Watch<'_>,
    ) -> Result<BranchRecord, StudyError> {
        let mut atlas = self.atlas(along, watch);
        let stretch = atlas.root(hopf)?;
        Ok(atlas.record(stretch, None, self.case.switch.depth))
    }

    /// The same without those that leave it.
    pub(in crate::study) fn stem(
        &self,
        along: Along,
        hopf: Option<Hopf>,
        watch: Watch<'_>,
    ) -> Result<Stretch, StudyError> {
        self.atlas(along, watch).root(hopf)
    }

    fn atlas<'a>(&'a self, along: Along, watch: Watch<'a>) -> Atlas<'a> {
        let (from, to) = along.span();
        Atlas {
            sought: self,
            along,
            settings: Settings::new(from, to, self.search.accuracy),
            known: Vec::new(),
            watch,
        }
    }
}

/// Branches under way.
struct Atlas<'a> {
    sought: &'a Sought<'a>,
    along: Along,
    settings: Settings,
    /// Special points whose other branch is already there.
    known: Vec<Here>,
    watch: Watch<'a>,
}

impl Atlas<'_> {
    /// The branch of the case.
    fn root(&mut self, hopf: Option<Hopf>) -> Result<Stretch, StudyError> {
        match hopf {
            Some(hopf) => self.hopf(&hopf),
            None => Ok(self.first()?),
        }
    }

    /// The first branch.
    fn first(&mut self) -> Result<Stretch, OrbitError> {
        let r = match self.sought.case.beginning {
            Beginning::End | Beginning::Hopf => self.settings.from,
            Beginning::At(from) => Along { from, ..self.along }.span().0,
        };
        let orbit = self.sought.orbit(r)?;
        self.through(&orbit)
    }

    /// The branch through an orbit: from one end, or from a place within in both directions.
    fn through(&mut self, orbit: &Orbit) -> Result<Stretch, OrbitError> {
        let Settings { from, to, .. } = self.settings;
        let begins = |value: f64| value != self.along.from;
        let both = matches!(self.sought.case.beginning, Beginning::At(value) if begins(value));
        let (r, ahead) = (orbit.r, to >= from);
        let forth = self.orbit(orbit, (r, ahead), orbit.work)?;
        if !both || forth.ended.is_closed() || forth.ended.is_interrupted() {
            return Ok(forth);
        }
        let back = self.orbit(orbit, (r, !ahead), Work::default())?;
        Ok(forth.behind(back, true))
    }

    fn hopf(&mut self, hopf: &Hopf) -> Result<Stretch, StudyError> {
        let Sought { family, search, .. } = self.sought;
        let (at, period) = ((hopf.r, hopf.state.as_slice()), hopf.period);
        let branch = OrbitBranch::from_hopf(family, at, period, search, self.settings)
            .map_err(StudyError::Hopf)?;
        Ok(self.follow(branch, Work::default()))
    }

    fn orbit(
        &mut self,
        orbit: &Orbit,
        at: (f64, bool),
        before: Work,
    ) -> Result<Stretch, OrbitError> {
        let Sought { family, search, .. } = self.sought;
        let branch = OrbitBranch::start_at(family, orbit, search, self.settings, at)
            .map_err(OrbitError::Newton)?;
        Ok(self.follow(branch, before))
    }

    fn follow(&mut self, branch: OrbitBranch, before: Work) -> Stretch {
        follow(self.sought, self.along, branch, before, self.watch)
    }

    /// A branch with those that leave it, `depth` switches deep.
    fn record(&mut self, stretch: Stretch, root: Option<Special>, depth: usize) -> BranchRecord {
        let mut special = numbered(&self.along, &stretch.located);
        let met = stretch.located.iter().filter(|event| event.last);
        self.known.extend(met.cloned());
        let mut branches = Vec::new();
        let mut stopped = stretch.is_interrupted();
        for (event, special) in stretch.located.iter().zip(&mut special) {
            if stopped {
                break;
            }
            if event.kind == Kind::Flip && !event.last {
                special.criticality = self.criticality(event);
            }
            if event.last || depth == 0 || !self.sought.case.switch.wants(event.kind) {
                continue;
            }
            if self.known.iter().any(|known| same(known, event)) {
                special.note = Some("the branch that leaves it is already there".to_owned());
                continue;
            }
            self.known.push(event.clone());
            match self.leave(event) {
                Ok((other, after)) => {
                    let root = Special {
                        after,
                        turns: 1 + usize::from(event.kind == Kind::Flip),
                        ..special.clone()
                    };
                    let below = self.record(other, Some(root), depth - 1);
                    stopped = below.is_interrupted();
                    branches.push(below);
                }
                Err(error) => special.note = Some(error.to_string()),
            }
        }
        BranchRecord {
            along: self.along,
            from: root.as_ref().map(|root| root.label.clone()),
            root,
            points: stretch.points,
            special,
            ended: stretch.ended,
            began: stretch.began,
            branches,
        }
    }

    /// The branch that leaves another at this point, and how many of its points come before: at a branch point it goes to
    /// both sides.
    fn leave(&mut self, event: &Here) -> Result<(Stretch, usize), SwitchError> {
        let forth = self.one_way(event, true);
        let stopped = forth.as_ref().is_ok_and(Stretch::is_interrupted);
        if event.kind == Kind::Flip || stopped {
            return forth.map(|forth| (forth, 0));
        }
        let back = self.one_way(event, false);
        match (forth, back) {
            (Ok(forth), Ok(back)) => {
                let before = back.points.len();
                Ok((forth.behind(back, false), before))
            }
            (Ok(one), Err(_)) | (Err(_), Ok(one)) => Ok((one, 0)),
            (Err(error), Err(_)) => Err(error),
        }
    }

    fn one_way(&mut self, event: &Here, forwards: bool) -> Result<Stretch, SwitchError> {
        let branch = self.switched(event, forwards)?;
        Ok(self.follow(branch, Work::default()))
    }

    fn switched(&self, event: &Here, forwards: bool) -> Result<OrbitBranch, SwitchError> {
        let Sought { family, search, .. } = self.sought;
        OrbitBranch::switch(family, event, forwards, search, self.settings)
    }

    /// On which side of a flip the doubled orbit lies: with the unstable orbit, or with the stable one.
    fn criticality(&self, event: &Here) -> Option<&'static str> {
        let branch = self.switched(event, true).ok()?;
        let error = event.error + self.sought.search.accuracy * event.point.r_size();
        let aside = |orbit: &Orbit| (orbit.r - event.r).abs() > CERTAIN * error;
        let aside = branch.take(LOOKED).find(aside)?;
        let change = event.more_unstable_towards(aside.r)?;
        Some(if change > 0 {
            "supercritical"
        } else {
            "subcritical"
        })
    }
}

/// Whether two special points are one, located on two branches.
fn same(a: &Located<Orbit>, b: &Located<Orbit>) -> bool {
    a.kind == b.kind
        && (a.r - b.r).abs() <= SAME_R * a.point.r_size()
        && (a.point.period / b.point.period - 1.0).abs() <= SAME_ORBIT
        && a.point.coincides(&b.point, SAME_ORBIT)
}

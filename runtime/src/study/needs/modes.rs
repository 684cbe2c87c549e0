//! How many modes of each structure a scene needs.

use super::stage::{Scene, Stage};
use crate::model::Structure;
use crate::study::system::System;

/// What a structure needs.
#[derive(Debug, Clone, PartialEq)]
pub struct ModesNeed {
    /// The structure.
    pub structure: &'static str,
    /// How many of its modes are kept.
    pub kept: usize,
    /// How many its file has.
    pub there: usize,
    /// How many are needed; `None` if more than are kept.
    pub needed: Option<usize>,
    /// The largest error of the answer with so many, measured.
    pub error: f64,
    /// Accepted steps of all orbits with all modes that are kept, and with those that are needed.
    pub steps: [u64; 2],
    /// The error of the answer by the modes that are not kept, estimated from the flexibility that they take along.
    pub beyond: f64,
    /// How many modes of its file are needed by that estimate, if it has as many.
    pub more: Option<usize>,
    /// The angular frequency of the first mode that is not kept, if the file has one.
    pub next: Option<f64>,
    /// What was measured, from the most modes to the fewest.
    pub scan: Vec<ModesPoint>,
}

/// The answer with so many modes of a structure.
#[derive(Debug, Clone, PartialEq)]
pub struct ModesPoint {
    /// How many.
    pub modes: usize,
    /// The largest share of the flexibility of a point that is left out.
    pub flexibility: f64,
    /// The largest error at any place; `None` where no orbit was found.
    pub error: Option<f64>,
    /// Accepted steps of all orbits.
    pub steps: u64,
}

impl System {
    /// What each structure needs, and the largest error of all of them reduced to that at once.
    pub(super) fn modes(&self, stage: &Stage) -> (Vec<ModesNeed>, Option<f64>) {
        let structures = self.info().structures;
        let mut needs: Vec<ModesNeed> = (0..structures.len())
            .map(|s| self.needed(stage, s))
            .collect();
        let mut together = None;
        while needs.len() > 1 {
            let counts: Vec<usize> = needs
                .iter()
                .map(|need| need.needed.unwrap_or(need.kept))
                .collect();
            together = self.with_modes(stage, &mut starts(stage), &counts).0;
            // Each meets the accuracy by itself: what they do together may not.
            let missed = together.is_none_or(|error| error > stage.accuracy);
            let loose = needs
                .iter_mut()
                .filter(|need| need.needed.is_some_and(|m| m < need.kept));
            match loose.max_by(|a, b| a.error.total_cmp(&b.error)) {
                Some(need) if missed => need.raise(),
                _ => break,
            }
        }
        (needs, together)
    }

    /// The scan of one structure, all others whole, from the most modes to the first that do not suffice.
    fn needed(&self, stage: &Stage, s: usize) -> ModesNeed {
        let structures = self.info().structures;
        let structure = &structures[s];
        let rigid = structure
            .modes
            .iter()
            .take_while(|mode| mode.share.is_none())
            .count();
        let mut counts: Vec<usize> = structures.iter().map(|one| one.kept).collect();
        let mut near = starts(stage);
        let steps = stage.scenes.iter().map(|scene| scene.answer.steps).sum();
        let mut scan = vec![ModesPoint {
            modes: structure.kept,
            flexibility: structure.share_beyond(structure.kept),
            error: Some(0.0),
            steps,
        }];
        for modes in (rigid.max(1)..structure.kept).rev() {
            counts[s] = modes;
            let (error, steps) = self.with_modes(stage, &mut near, &counts);
            scan.push(ModesPoint {
                modes,
                flexibility: structure.share_beyond(modes),
                error,
                steps,
            });
            if error.is_none_or(|error| error > stage.accuracy) {
                break;
            }
        }
        ModesNeed::read(structure, scan, stage.accuracy)
    }

    /// The largest error of the answer with so many modes of each structure, and the steps of all orbits; each orbit is
    /// looked for near the last that was found.
    fn with_modes(
        &self,
        stage: &Stage,
        near: &mut [Option<Scene>],
        counts: &[usize],
    ) -> (Option<f64>, u64) {
        let (mut worst, mut steps) = (Some(0.0_f64), 0);
        for (scene, near) in stage.scenes.iter().zip(near) {
            let found = self.thinned(scene, near.as_ref().unwrap_or(scene), counts);
            let error = found
                .as_ref()
                .ok()
                .map(|found| scene.answer.error(&found.answer));
            worst = worst.zip(error).map(|(worst, error)| worst.max(error));
            *near = found.ok();
            steps += near.as_ref().map_or(0, |near| near.answer.steps);
        }
        (worst, steps)
    }
}

fn starts(stage: &Stage) -> Vec<Option<Scene>> {
    stage.scenes.iter().map(|_| None).collect()
}

impl ModesNeed {
    /// What a scan says: the fewest modes with which, and with any more than which, the accuracy is met.
    fn read(structure: &Structure, scan: Vec<ModesPoint>, accuracy: f64) -> Self {
        let (kept, there) = (structure.kept, structure.modes.len());
        let rate = rate(&scan);
        let beyond = rate * structure.share_beyond(kept);
        let meets =
            |point: &&ModesPoint| point.error.is_some_and(|error| error + beyond <= accuracy);
        let least = scan.iter().take_while(meets).last();
        let more = (kept..=there).find(|m| rate * structure.share_beyond(*m) <= accuracy);
        Self {
            structure: structure.name,
            kept,
            there,
            needed: least.map(|point| point.modes),
            error: least.and_then(|point| point.error).unwrap_or(0.0),
            steps: [scan[0].steps, least.unwrap_or(&scan[0]).steps],
            beyond,
            more: more.filter(|_| least.is_none()),
            next: structure.modes.get(kept).map(|mode| mode.frequency),
            scan,
        }
    }

    /// One mode more.
    fn raise(&mut self) {
        self.needed = self.needed.map(|m| m + 1);
        let mut scan = self.scan.iter();
        if let Some(point) = scan.find(|point| Some(point.modes) == self.needed) {
            self.error = point.error.unwrap_or(0.0);
            self.steps[1] = point.steps;
        }
    }
}

/// The error of the answer per share of the flexibility that is left out: from the most modes whose loss takes along as
/// much of it as is left out already, or else from the fewest. A share for a share where nothing was measured.
fn rate(scan: &[ModesPoint]) -> f64 {
    let first = scan.first().map_or(0.0, |point| point.flexibility);
    let measured: Vec<[f64; 2]> = scan
        .iter()
        .filter_map(|point| Some([point.flexibility - first, point.error?]))
        .filter(|[flexibility, _]| *flexibility > 0.0)
        .collect();
    let alike = measured
        .iter()
        .find(|[flexibility, _]| *flexibility >= first);
    let told = alike.or(measured.last());
    told.map_or(1.0, |[flexibility, error]| error / flexibility)
}

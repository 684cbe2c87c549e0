//! Where a scene is judged.

use super::answer::{Answer, Of};
use super::topic::{Topic, Watch};
use crate::shooting::Orbit;
use crate::study::ended::Ended;
use crate::study::error::StudyError;
use crate::study::orbit::OrbitRecord;
use crate::study::question::{Along, Case, Dynamics};
use crate::study::system::System;

/// Orbits are found this much more accurately than they are judged.
const FINER: f64 = 1e-3;
/// The accuracies of orbits that this leads to.
const LEAST: f64 = 1e-11;
const MOST: f64 = 1e-6;

/// An orbit at which a scene was judged.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed {
    /// Values of all parameters.
    pub parameters: Vec<f64>,
    /// The period.
    pub period: f64,
    /// Accepted steps once around.
    pub steps: u64,
}

/// An orbit with its answer.
pub(super) struct Scene {
    /// What leads to the orbit at once.
    pub(super) case: Case,
    pub(super) orbit: Orbit,
    pub(super) answer: Answer,
}

/// All orbits at which a scene is judged.
pub(super) struct Stage {
    pub(super) accuracy: f64,
    pub(super) along: Option<Along>,
    pub(super) scenes: Vec<Scene>,
    /// The words of all orbits on the way.
    pub(super) words: Vec<String>,
    pub(super) ended: Option<Ended>,
}

impl Stage {
    pub(super) fn placed(&self) -> Vec<Placed> {
        let placed = |scene: &Scene| Placed {
            parameters: scene.case.parameters.clone(),
            period: scene.orbit.period,
            steps: scene.answer.steps,
        };
        self.scenes.iter().map(placed).collect()
    }
}

impl System {
    /// The orbit of a case, or those of its range.
    pub(super) fn stage(&self, case: &Case, watch: Watch<'_>) -> Result<Stage, StudyError> {
        let fine = Case {
            accuracy: (FINER * case.accuracy).clamp(LEAST, MOST),
            dynamics: match self.info().touches() {
                true => Dynamics::Exact,
                false => Dynamics::Smooth,
            },
            ..case.clone()
        };
        let mut stage = Stage {
            accuracy: case.accuracy,
            along: case.along,
            scenes: Vec::new(),
            words: Vec::new(),
            ended: None,
        };
        if case.along.is_none() {
            stage.scenes.push(self.scene(fine)?);
            return Ok(stage);
        }
        let branch = self.branch_watched(&fine, &mut |_| watch(Topic::Orbits))?;
        stage.words = branch
            .points
            .iter()
            .filter_map(|point| point.word.clone())
            .collect();
        for place in self.telling_places(&branch.points) {
            let point = &branch.points[place];
            stage.scenes.push(self.scene(Case {
                parameters: point.parameters.clone(),
                along: None,
                start: Some(point.state.clone()),
                modes: point.modes.clone(),
                period: Some(point.period),
                ..fine.clone()
            })?);
        }
        stage.ended = Some(branch.ended);
        Ok(stage)
    }

    /// The orbit of a case that follows nothing, with its answer.
    pub(super) fn scene(&self, case: Case) -> Result<Scene, StudyError> {
        let orbit = self.sought(&case)?.orbit(0.0);
        let orbit = orbit.map_err(|error| self.sharpened(&case, error))?;
        let answer = self.answer(&case, &orbit)?;
        let case = Case {
            start: Some(orbit.place.state.clone()),
            modes: orbit.place.modes.clone(),
            period: Some(orbit.period),
            ..case
        };
        Ok(Scene {
            case,
            orbit,
            answer,
        })
    }

    /// The ends of a branch, and where on it each thing that is measured is largest.
    fn telling_places(&self, points: &[OrbitRecord]) -> Vec<usize> {
        let measured = Of::all(self.info());
        let largest = measured.iter().filter_map(|of| {
            let size = |place: &usize| of.bound(self.info(), &points[*place].max_abs);
            (0..points.len()).max_by(|a, b| size(a).total_cmp(&size(b)))
        });
        let mut places: Vec<usize> = largest.collect();
        places.extend([0, points.len().saturating_sub(1)]);
        places.retain(|place| *place < points.len());
        places.sort_unstable();
        places.dedup();
        places
    }
}

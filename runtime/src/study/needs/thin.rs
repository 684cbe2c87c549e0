//! A scene with fewer modes, or with other parameters.

use super::stage::Scene;
use crate::model::StructureMode;
use crate::study::error::StudyError;
use crate::study::question::Case;
use crate::study::system::System;

impl System {
    /// The scene with only the first modes of each structure, so many of each, near an orbit that is already known.
    pub(super) fn thinned(
        &self,
        scene: &Scene,
        near: &Scene,
        counts: &[usize],
    ) -> Result<Scene, StudyError> {
        let mut parameters = scene.case.parameters.clone();
        let mut start = near.orbit.place.state.clone();
        for mode in self.left_out(counts) {
            for place in mode.amplitude.into_iter().chain(mode.rate) {
                start[place] = 0.0;
            }
            if let Some(share) = mode.share {
                parameters[share] = 0.0;
            }
        }
        let case = Case {
            parameters,
            ..scene.case.clone()
        };
        self.nearby(case, start, near.orbit.period)
    }

    /// The modes that are left out where so many of each structure are kept.
    fn left_out(&self, counts: &[usize]) -> impl Iterator<Item = &'static StructureMode> {
        let structures = self.info().structures.iter().zip(counts.to_vec());
        structures.flat_map(|(one, count)| one.modes[..one.kept].iter().skip(count))
    }

    /// The orbit of a case: near this start, or, where Newton's method does not reach it, wherever the case leads.
    pub(super) fn nearby(
        &self,
        case: Case,
        start: Vec<f64>,
        period: f64,
    ) -> Result<Scene, StudyError> {
        let guessed = |start, period| Case {
            start,
            period,
            ..case.clone()
        };
        let near = self.scene(guessed(Some(start), Some(period)));
        near.or_else(|_| self.scene(guessed(None, None)))
    }
}

//! All motions of a case.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use super::areas::areas;
use super::edge::edges;
use super::ground::Ground;
use super::record::{Attractor, AttractorsRecord, Fate, Found, Survey};
use super::scouted::Scouted;
use super::setting::Sampling;
use crate::flow::FlowError;
use crate::study::error::StudyError;
use crate::study::question::Case;
use crate::study::system::System;
use crate::study::work::{List, Watch};

impl System {
    /// On what motions from starts in a region settle: `list` has an item for each start at each of the values that are
    /// followed, value after value, and `watch` sees each. Areas are found once all starts are there.
    ///
    /// # Errors
    /// The case cannot be asked.
    pub fn attractors_watched(
        &self,
        case: &Case,
        sampling: &Sampling,
        list: &List<Fate>,
        watch: Watch<'_, Fate>,
    ) -> Result<AttractorsRecord, StudyError> {
        self.check(case)?;
        let (region, starts) = (&sampling.region, sampling.starts);
        let stations = stations(case, sampling.values);
        let scouted: Vec<OnceLock<Result<Scouted<'_>, FlowError>>> =
            stations.iter().map(|_| OnceLock::new()).collect();
        let at = |station: usize| {
            scouted[station].get_or_init(|| {
                let ground = Ground::new(self, stations[station].1.clone(), region)?;
                Ok(Scouted::new(ground, starts))
            })
        };
        let one = |number: usize| match at(number / starts) {
            Ok(scouted) => scouted.fate(&scouted.start(number % starts)),
            Err(error) => {
                let start = region.start(number % starts, &self.start(case));
                let class = super::record::Class::Failed;
                Fate::Other(Box::new(Attractor::bare(
                    class,
                    &start,
                    Some(error.to_string()),
                )))
            }
        };
        let count = stations.len().saturating_mul(starts);
        let found = list.work(count, one, watch);
        let surveys = (0..stations.len()).filter_map(|station| {
            let fates = found.range(station * starts..(station + 1) * starts);
            let fates: BTreeMap<usize, &Fate> = fates.map(|(n, fate)| (n % starts, fate)).collect();
            let scouted = at(station).as_ref().ok()?;
            let mut survey = survey(scouted, stations[station].0, &fates);
            let whole = found.len() == count;
            if whole && sampling.areas && region.sides.len() == 2 {
                measure(scouted, &mut survey, list.threads);
            }
            if whole && sampling.edges {
                survey.edges = edges(scouted, &survey);
            }
            if whole && sampling.further {
                survey.further = scouted.ground().further(&survey);
            }
            Some(survey)
        });
        Ok(AttractorsRecord {
            surveys: surveys.collect(),
            sampling: sampling.clone(),
            along: case.along,
            missing: count - found.len(),
        })
    }
}

/// The values of what is followed, smallest first, each with the case there.
fn stations(case: &Case, values: usize) -> Vec<(Option<f64>, Case)> {
    let alone = |case: Case| Case {
        along: None,
        ..case
    };
    match case.along {
        None => vec![(None, alone(case.clone()))],
        Some(along) => {
            let values = along.spaced(values).into_iter().map(|r| along.value(r));
            values
                .map(|value| (Some(value), alone(case.at(value))))
                .collect()
        }
    }
}

/// The motions with their starts: those that scouts have not found are found where starts settle on them.
fn survey(scouted: &Scouted<'_>, r: Option<f64>, fates: &BTreeMap<usize, &Fate>) -> Survey {
    let mut attractors: Vec<Attractor> = scouted.attractors.clone();
    let mut starts: Vec<(Vec<f64>, usize)> = Vec::new();
    for (k, fate) in fates {
        let of = match fate {
            // What is no motion here was noted by another program.
            Fate::Known(of) if *of >= scouted.attractors.len() => continue,
            Fate::Known(of) => *of,
            Fate::Other(new) => {
                let known = attractors.iter().position(|known| scouted.same(known, new));
                known.unwrap_or_else(|| {
                    attractors.push(*new.clone());
                    attractors.len() - 1
                })
            }
        };
        starts.push((scouted.start(*k), of));
    }
    let count = |of: usize| starts.iter().filter(|start| start.1 == of).count();
    let mut order: Vec<(usize, usize)> = (0..attractors.len()).map(|of| (of, count(of))).collect();
    order.retain(|(_, count)| *count > 0);
    order.sort_by_key(|(of, count)| (std::cmp::Reverse(*count), *of));
    for start in &mut starts {
        start.1 = order.iter().position(|(of, _)| *of == start.1).unwrap_or(0);
    }
    let found = order
        .iter()
        .map(|(of, count)| Found::new(attractors[*of].clone(), *count, fates.len()));
    Survey {
        r,
        found: found.collect(),
        edges: Vec::new(),
        further: Vec::new(),
        starts,
    }
}

/// Measures the areas of the basins of all motions that were found.
fn measure(scouted: &Scouted<'_>, survey: &mut Survey, threads: Option<usize>) {
    let known = &survey.found;
    let place = |found: &Attractor| {
        known
            .iter()
            .position(|one| scouted.same(&one.attractor, found))
    };
    let basin = |at: [f64; 2]| {
        let of = match scouted.fate(&scouted.at(&at)) {
            Fate::Known(of) => place(&scouted.attractors[of]),
            Fate::Other(new) => place(&new),
        };
        of.unwrap_or(known.len())
    };
    let found = areas(known.len() + 1, threads, &basin);
    for (one, share) in survey.found.iter_mut().zip(found.shares) {
        one.area = Some([share, found.error]);
    }
}

//! All motions of a case.

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::sync::OnceLock;

use super::ground::Ground;
use super::record::{Attractor, AttractorsRecord, Fate, Found, Survey};
use super::scouted::Scouted;
use super::setting::Region;
use crate::flow::FlowError;
use crate::study::error::StudyError;
use crate::study::question::Case;
use crate::study::system::System;
use crate::study::work::{Item, List};

impl System {
    /// On what motions from starts in a region settle: `list` has `starts` items for each of the values that are
    /// followed, value after value, and `watch` sees each.
    ///
    /// # Errors
    /// The case cannot be asked.
    pub fn attractors(
        &self,
        case: &Case,
        region: &Region,
        (values, starts): (usize, usize),
        list: &List<Fate>,
        watch: &(dyn Fn(Item<'_, Fate>) -> ControlFlow<()> + Sync),
    ) -> Result<AttractorsRecord, StudyError> {
        self.check(case)?;
        let stations = stations(case, values);
        let scouted: Vec<OnceLock<Result<Scouted<'_>, FlowError>>> =
            stations.iter().map(|_| OnceLock::new()).collect();
        let at = |station: usize| {
            scouted[station].get_or_init(|| {
                let ground = Ground::new(self, stations[station].1.clone(), region)?;
                Ok(Scouted::new(ground, starts))
            })
        };
        let one = |number: usize| match at(number / starts) {
            Ok(scouted) => scouted.fate(number % starts),
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
        let found = list.work(one, watch);
        let surveys = (0..stations.len()).filter_map(|station| {
            let fates = found.range(station * starts..(station + 1) * starts);
            let fates: BTreeMap<usize, &Fate> = fates.map(|(n, fate)| (n % starts, fate)).collect();
            let scouted = at(station).as_ref().ok()?;
            Some(survey(scouted, stations[station].0, &fates))
        });
        Ok(AttractorsRecord {
            surveys: surveys.collect(),
            region: region.clone(),
            along: case.along,
            starts,
            missing: list.count - found.len(),
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
        starts,
    }
}

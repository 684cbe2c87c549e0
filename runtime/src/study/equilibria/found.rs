//! The equilibria of a system: of its exact friction, of its copies, and what the one says of the other.

use std::ops::ControlFlow;

use super::counterpart::Counterpart;
use super::modes::{sliding_mode, sliding_modes, spelt, sticking_modes};
use super::record::{EquilibriaRecord, EquilibriumRecord, Extent};
use super::special::numbered;
use crate::continuation::{Ending, Kind, Walked};
use crate::equilibrium::{
    EquilibriumPoint, Proof, Spectrum, StickingSet, Unproven, find, find_around, follow, largest,
    prove, settings, sizes_at, starts, sticking_sets,
};
use crate::field::exact::Mode;
use crate::flow::FlowError;
use crate::model::ModelInfo;
use crate::motion::{Family, Flow, Modes, Place, apart};
use crate::study::ended::Ended;
use crate::study::error::StudyError;
use crate::study::question::{Along, Case};
use crate::study::system::System;

/// How far along a branch how it goes on is told, in scaled coordinates.
const STEP: f64 = 1e-6;

/// Told of each point of a branch.
pub(in crate::study) type Watch<'a> = &'a mut dyn FnMut(&EquilibriumRecord) -> ControlFlow<()>;

impl System {
    /// Every equilibrium that is found, and for exact dynamics every set of sticking ones.
    ///
    /// # Errors
    /// None was found.
    pub fn equilibria(&self, case: &Case) -> Result<Vec<EquilibriumRecord>, StudyError> {
        self.may_rest(case)?;
        let places = starts(&self.start(case));
        let (family, flow) = (self.family(case), self.at(case)?);
        let modes = |y: &[f64]| sliding_modes(&*flow, self.info(), y);
        let sliding = find_around(&family, self.beginning(case), &places, modes);
        let mut found: Vec<_> = sliding
            .into_iter()
            .map(|one| self.record(case, one.place, &one.spectrum))
            .collect();
        if self.touches(case) {
            let modes = sticking_modes(&*flow, self.info());
            let sets = sticking_sets(&*flow, &places, &modes).into_iter();
            found.extend(sets.map(|set| self.set_record(case, set)));
        }
        if found.is_empty() {
            return Err(StudyError::NoEquilibrium {
                starts: places.len(),
            });
        }
        Ok(found)
    }

    /// The branch of equilibria along the design variable of the case, from the first that is found; `watch` sees each
    /// point as it is found, and may end the branch there.
    ///
    /// # Errors
    /// There is no equilibrium to begin with.
    pub fn equilibria_along_watched(
        &self,
        case: &Case,
        watch: Watch<'_>,
    ) -> Result<EquilibriaRecord, StudyError> {
        Ok(self.equilibria_stem(case, watch)?.0)
    }

    /// The same with the modes that contacts have along it.
    pub(in crate::study) fn equilibria_stem(
        &self,
        case: &Case,
        watch: Watch<'_>,
    ) -> Result<(EquilibriaRecord, Modes), StudyError> {
        self.may_rest(case)?;
        let along = case.along.ok_or(StudyError::NothingToFollow)?;
        let family = self.family(case);
        let first = self.first(case, &family)?;
        let mut points = Vec::new();
        let mut take = |spot: &EquilibriumPoint| {
            let at = case.at(along.value(spot.r));
            let place = Place {
                state: spot.state.clone(),
                modes: first.modes.clone(),
            };
            let point = EquilibriumRecord {
                r: Some(along.value(spot.r)),
                beside: Some(beside(along, spot)),
                ..self.record(&at, place, &spot.spectrum)
            };
            let verdict = watch(&point);
            points.push(point);
            verdict
        };
        let (from, to) = along.span();
        let (walked, work) = follow(&family, &first, settings(from, to), &mut take)
            .map_err(StudyError::Equilibrium)?;
        let mut special = numbered(along, (&family, &first.modes), &walked.located);
        if let Some(exact) = self.counterpart(case) {
            for point in &mut special {
                point.artefact = exact.lacks(along, point);
            }
        }
        let branch = EquilibriaRecord {
            along,
            special,
            ended: ended(self.info(), &walked, along, &first.modes),
            work,
            others: self.not_passed(&case.at(along.value(self.beginning(case))), &points),
            points,
        };
        Ok((branch, first.modes))
    }

    /// For each equilibrium that was found at the case a proof that it exists and is the only one in a box, or why there
    /// is none.
    #[must_use]
    pub fn proofs(&self, case: &Case, found: &[EquilibriumRecord]) -> Vec<Result<Proof, Unproven>> {
        found.iter().map(|one| self.proof(case, one)).collect()
    }

    /// Whether the case can be asked, and its model rests at all: one with a drive has no equilibrium, and one whose laws
    /// have stops has none that stands alone.
    fn may_rest(&self, case: &Case) -> Result<(), StudyError> {
        self.check(case)?;
        let info = self.info();
        let model = info.command;
        let mut memories = info.memories.iter();
        if let Some(memory) = memories.find(|memory| memory.law.has_stops()) {
            let law = memory.law.name;
            return Err(StudyError::NotIsolated { model, law });
        }
        match info.drive {
            None => Ok(()),
            Some(phase) => Err(StudyError::Driven {
                model,
                phase: info.states[phase].name,
            }),
        }
    }

    /// A proof that the equilibrium exists, in the mode in which its contacts slide there.
    fn proof(&self, case: &Case, found: &EquilibriumRecord) -> Result<Proof, Unproven> {
        // Without a flow no contact is known to slide, and nothing is proven.
        let modes = self.touches(case).then(|| {
            let flow = self.at(case);
            let mode = |flow: Box<dyn Flow>| sliding_mode(&*flow, self.info(), &found.state);
            flow.map_or_else(|_| Vec::new(), mode)
        });
        prove(&*self.enclosure(case, modes.as_deref()), &found.state)
    }

    /// The equilibrium that is nearest to the start of the case: one that slides, or a single one that contacts hold.
    fn first(&self, case: &Case, family: &Family) -> Result<Place, StudyError> {
        let places = starts(&self.start(case));
        let flow = self.at(case)?;
        let modes = |y: &[f64]| sliding_modes(&*flow, self.info(), y);
        let r = self.beginning(case);
        let from = |start: &Vec<f64>| {
            let found = find(family, r, std::slice::from_ref(start), modes);
            (!found.is_empty()).then_some(found)
        };
        let sliding = places.iter().find_map(from).unwrap_or_default();
        let from = if sliding.is_empty() { places.len() } else { 1 };
        let sets = if self.touches(case) {
            sticking_sets(
                &*flow,
                &places[..from],
                &sticking_modes(&*flow, self.info()),
            )
        } else {
            Vec::new()
        };
        let single = sets.iter().filter(|set| set.dimension == 0);
        let held = single.map(|set| Place {
            state: set.state.clone(),
            modes: set.modes.clone(),
        });
        let found: Vec<Place> = sliding
            .into_iter()
            .map(|one| one.place)
            .chain(held)
            .collect();
        let first = places[0].iter().map(|y| y.abs()).collect();
        let sizes = found.iter().map(|place| sizes_at(family, r, place));
        let sizes = largest(sizes.chain([first]));
        let far = |place: &Place| apart(&place.state, &places[0], &sizes);
        found
            .into_iter()
            .min_by(|a, b| far(a).total_cmp(&far(b)))
            .ok_or_else(|| self.none(&sets, places.len()))
    }

    /// Why there is nothing to follow.
    fn none(&self, sets: &[StickingSet], starts: usize) -> StudyError {
        let modes = sets.iter().filter_map(|set| spelt(self.info(), &set.modes));
        let modes: Vec<String> = modes.collect();
        if modes.is_empty() {
            return StudyError::NoEquilibrium { starts };
        }
        let modes = modes.join(", ");
        StudyError::OnlySets { modes }
    }

    /// The exact system of which a case asks a smooth copy.
    fn counterpart(&self, case: &Case) -> Option<Counterpart<'_>> {
        let copy = !self.info().contacts.is_empty() && case.smoothing().is_some();
        copy.then(|| Counterpart::new(self, case))
    }

    /// The record of an equilibrium, that of a copy compared with the exact system.
    fn record(&self, case: &Case, place: Place, spectrum: &Spectrum) -> EquilibriumRecord {
        let mut record = EquilibriumRecord {
            r: None,
            parameters: case.parameters.clone(),
            dynamics: case.dynamics,
            mode: spelt(self.info(), &place.modes),
            state: place.state,
            eigenvalues: spectrum.eigenvalues.clone(),
            stability: spectrum.stability,
            set: None,
            artefact: false,
            beside: None,
        };
        if let Some(exact) = self.counterpart(case) {
            record.artefact = exact.differs(&record);
        }
        record
    }

    fn set_record(&self, case: &Case, set: StickingSet) -> EquilibriumRecord {
        let extent = Extent {
            dimension: set.dimension,
            low: set.low,
            high: set.high,
        };
        let place = Place {
            state: set.state,
            modes: set.modes,
        };
        EquilibriumRecord {
            set: (set.dimension > 0).then_some(extent),
            ..self.record(case, place, &set.spectrum)
        }
    }
}

/// The design variable and the state a little further along the branch.
fn beside(along: Along, spot: &EquilibriumPoint) -> (f64, Vec<f64>) {
    let order = spot.state.len();
    let moved = spot.state.iter().zip(spot.way.iter());
    let state = moved.map(|(value, rate)| value + STEP * rate).collect();
    (along.value(spot.r + STEP * spot.way[order]), state)
}

/// Why a branch ended: the contact whose way of sliding ends is named.
fn ended(
    info: &ModelInfo,
    walked: &Walked<EquilibriumPoint, FlowError>,
    along: Along,
    modes: &Modes,
) -> Ended {
    let mut ended = Ended::of(
        &walked.ending,
        along,
        walked.points.last().map(|last| last.r),
    );
    if let Ending::At(Kind::BoundaryEquilibrium, _) = walked.ending {
        let margin = walked.points.last().and_then(EquilibriumPoint::margin);
        let contact = margin.map_or(usize::MAX, |(contact, _)| contact);
        let name = info.contact(contact).unwrap_or("?");
        let mode = modes.get(contact).copied();
        ended.reason = if mode == Some(Mode::Rest) {
            format!("the reaction of `{name}` reaches zero, and with it this contact ends")
        } else if mode == Some(Mode::Stick) {
            format!("the force that holds `{name}` reaches its limit, and with it sticking ends")
        } else if contact < info.contacts.len() {
            format!(
                "the relative speed of `{name}` reaches zero, and with it this way of sliding ends"
            )
        } else {
            format!("the gap of `{name}` reaches zero, and with it this way of pressing ends")
        };
    }
    ended
}

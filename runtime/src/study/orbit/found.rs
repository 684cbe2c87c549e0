//! The periodic orbit of a case.

use super::held::Held;
use super::record::{Beside, CertifiedOrbit, OrbitRecord};
use super::sought::Sought;
use crate::field::Work;
use crate::flow::FlowError;
use crate::harmonics::{Around, Harmonics, harmonics, series};
use crate::integrate::Tolerance;
use crate::motion::word;
use crate::shooting::{Guess, Orbit, certify};
use crate::study::error::StudyError;
use crate::study::question::Case;
use crate::study::system::System;

/// What an orbit may be off by over what its start moves by on a finer flow: elsewhere it may move farther.
const DOUBT: f64 = 2.0;

impl System {
    /// The periodic orbit that is reached from the start of the case.
    ///
    /// # Errors
    /// None was found.
    pub fn orbit(&self, case: &Case) -> Result<OrbitRecord, StudyError> {
        let (sought, orbit) = self.found(case)?;
        Ok(sought.record(&orbit))
    }

    fn found<'a>(&'a self, case: &'a Case) -> Result<(Sought<'a>, Orbit), StudyError> {
        let sought = self.sought(case)?;
        let orbit = sought.orbit(self.beginning(case));
        let orbit = orbit.map_err(|error| self.sharpened(case, error))?;
        Ok((sought, orbit))
    }

    /// The same orbit with its certificate: how near to it a true orbit is, and only one.
    ///
    /// # Errors
    /// None was found. An orbit that cannot be certified is no error: it comes with the reason.
    pub fn certified_orbit(&self, case: &Case) -> Result<CertifiedOrbit, StudyError> {
        let (sought, orbit) = self.found(case)?;
        let found = Guess {
            place: orbit.heading.start.clone(),
            ..orbit.guess()
        };
        Ok(CertifiedOrbit {
            certificate: certify(&sought.family, orbit.r, &found, case.accuracy),
            orbit: sought.record(&orbit),
        })
    }

    /// How many harmonics the Fourier series of each state of an orbit of this case takes, for each of these accuracies
    /// ([`series`]).
    ///
    /// # Errors
    /// The orbit cannot be followed once around.
    pub fn series(
        &self,
        case: &Case,
        orbit: &OrbitRecord,
        accuracies: &[f64],
    ) -> Result<Vec<Vec<Option<usize>>>, StudyError> {
        let flow = self.at(case)?;
        let around = Around {
            place: &flow.place_in(&orbit.state, &orbit.modes)?,
            period: orbit.period,
            shift: orbit.shift.as_deref().unwrap_or_default(),
        };
        Ok(series(flow.as_ref(), around, accuracies)?)
    }
}

impl Sought<'_> {
    /// The harmonics of an orbit that the case asks for; their errors are also those of the orbit.
    fn harmonics(&self, orbit: &Orbit) -> Result<Harmonics, FlowError> {
        let around = Around {
            place: &orbit.place,
            period: orbit.period,
            shift: orbit.shift.as_deref().unwrap_or_default(),
        };
        let mut found = self.harmonics_at(orbit, orbit.r, around)?;
        // The period of a driven orbit is certain, and its start has been corrected.
        let doubt = self.family.phase().map_or(orbit.error_estimate, |_| 0.0);
        for harmonic in &mut found.all {
            for (error, size) in harmonic.error.iter_mut().zip(orbit.magnitude()) {
                *error += doubt * size;
            }
        }
        Ok(found)
    }

    /// The harmonics of a motion at r once around, which is as large as this orbit.
    fn harmonics_at(
        &self,
        orbit: &Orbit,
        r: f64,
        around: Around<'_>,
    ) -> Result<Harmonics, FlowError> {
        let orders = &self.case.harmonics;
        if orders.is_empty() {
            return Ok(Harmonics::default());
        }
        let family = self.family.with_magnitude(&orbit.magnitude());
        let tolerance = Tolerance::for_accuracy(self.case.accuracy);
        harmonics(&family, r, around, orders, tolerance)
    }

    /// The orbit a little further along its branch, and what that cost.
    fn beside(&self, orbit: &Orbit) -> (Option<Beside>, Work) {
        let tolerance = Tolerance::for_accuracy(self.case.accuracy);
        let family = self.family.with_tolerance(tolerance);
        let Some(beside) = orbit.beside(&family) else {
            return Default::default();
        };
        let counted = orbit.heading.start.state == orbit.place.state;
        let around = Around {
            place: &beside.start,
            period: beside.period,
            shift: &[],
        };
        let harmonics = counted
            .then(|| self.harmonics_at(orbit, beside.r, around).ok())
            .flatten();
        let along = self.case.along.map(|along| along.value(beside.r));
        let record = Beside {
            r: along.unwrap_or(beside.r),
            period: beside.period,
            max: beside.max,
            min: beside.min,
            section: beside.section,
            harmonics: harmonics.unwrap_or_default().all,
        };
        (Some(record), beside.work)
    }

    /// The orbit as it is reported.
    pub(in crate::study) fn record(&self, orbit: &Orbit) -> OrbitRecord {
        let r = self.case.along.map(|along| along.value(orbit.r));
        let case = r.map_or_else(|| self.case.clone(), |r| self.case.at(r));
        let rubs = self.system.touches(self.case);
        let harmonics = self.harmonics(orbit);
        let moved = harmonics.as_ref().map_or(0.0, |found| moved(found, orbit));
        let (beside, spent) = self.beside(orbit);
        let mut work = orbit.work;
        work += spent;
        OrbitRecord {
            r,
            parameters: case.parameters,
            dynamics: case.dynamics,
            state: orbit.place.state.clone(),
            modes: orbit.place.modes.clone(),
            period: orbit.period,
            max: orbit.max.clone(),
            min: orbit.min.clone(),
            max_abs: orbit.max_abs(),
            period_count: orbit.period_count,
            section: orbit.section.clone(),
            shift: orbit.shift.clone(),
            floquet: orbit.floquet.clone(),
            held: orbit
                .pins
                .iter()
                .map(|pin| Held::new(pin, &orbit.place.state, self.system.info()))
                .collect(),
            harmonics: harmonics.map(|found| found.all),
            word: rubs.then(|| word(self.system.info(), &orbit.segments)),
            residual: orbit.residual,
            error_estimate: orbit.error_estimate.max(moved),
            beside,
            work,
        }
    }
}

/// By how much an orbit may be off, relative to the extents of its states, as its start moves on a finer flow.
fn moved(found: &Harmonics, orbit: &Orbit) -> f64 {
    let sizes = orbit.magnitude();
    let moved = found.moved.iter().zip(sizes).map(|(by, size)| by / size);
    DOUBT * moved.fold(0.0, f64::max)
}

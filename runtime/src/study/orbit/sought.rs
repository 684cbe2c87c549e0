//! Where the orbit of a case is looked for, and what is told where there is none.

use super::seed::{Seed, on_the_belt};
use crate::equilibrium::find;
use crate::flow::FlowError;
use crate::integrate::Tolerance;
use crate::lyapunov::lyapunov;
use crate::model::{Values, brief};
use crate::motion::Family;
use crate::shooting::{Orbit, OrbitError, Search, closest, settled};
use crate::study::equilibria::sliding_modes;
use crate::study::question::{Case, Dynamics};
use crate::study::system::System;

/// A motion that has settled is this near to its equilibrium.
const SETTLED: f64 = 1e-3;

/// For how long the Lyapunov exponent of a motion that has not settled is measured: so many laps, each a share of the time
/// after which that was said; and how closely the motion is followed.
const LAPS: usize = 32;
const LAP: f64 = 1e-3;
const ROUGH: f64 = 1e-6;

/// How much a failure tells of the system: that motions settle elsewhere is more than that a search ended.
fn tells(error: &OrbitError) -> u8 {
    match error {
        OrbitError::NotIsolated { .. } => 3,
        OrbitError::Equilibrium { .. } | OrbitError::Steady { .. } => 2,
        OrbitError::NotSettled { .. } => 1,
        OrbitError::Passed { .. } | OrbitError::Newton(_) | OrbitError::Flow(_) => 0,
    }
}

/// A family with what is sought in it.
pub(in crate::study) struct Sought<'a> {
    pub(in crate::study) system: &'a System,
    pub(in crate::study) family: Family,
    pub(in crate::study) case: &'a Case,
    /// Tried in this order.
    seeds: Vec<Seed>,
    pub(in crate::study) search: Search,
}

impl System {
    /// What is sought in a case.
    ///
    /// # Errors
    /// The case has no flow.
    pub(in crate::study) fn sought<'a>(&'a self, case: &'a Case) -> Result<Sought<'a>, FlowError> {
        Ok(Sought {
            system: self,
            family: self.family(case),
            case,
            seeds: self.seeds(case)?,
            search: Search {
                start: self.start(case),
                modes: case.modes.clone(),
                period: case.period,
                accuracy: case.accuracy,
                segments: 1,
            },
        })
    }

    /// Where orbits are looked for, first places first.
    fn seeds(&self, case: &Case) -> Result<Vec<Seed>, FlowError> {
        let start = self.start(case);
        let declared = Seed::at(start.clone());
        let period = case.period;
        let mut seeds = match (&case.start, period) {
            (Some(_), None) => {
                let settles = true;
                return Ok(vec![Seed {
                    settles,
                    ..declared
                }]);
            }
            (Some(_), Some(_)) => return Ok(vec![Seed { period, ..declared }]),
            (None, Some(_)) => {
                let near = Seed {
                    period,
                    ..declared.clone()
                };
                return Ok(vec![near, declared]);
            }
            _ if self.touches(case) => on_the_belt(self.at(case)?.as_ref(), self.info(), &start),
            _ if self.info().contacts.is_empty() => Vec::new(),
            _ => self.exact_orbit(case).map_or_else(Vec::new, |seed| {
                // A copy may be out of reach of Newton and yet settle from there.
                let settling = Seed::at(seed.start.clone());
                vec![seed, settling]
            }),
        };
        // A drive lets nothing rest where it is declared to begin: what comes of that is what is meant.
        let settles = self.touches(case) && self.info().drive.is_some();
        seeds.insert(if settles { 0 } else { seeds.len() }, declared);
        Ok(different(seeds))
    }

    /// The orbit of the exact system as a seed for its smooth copies.
    fn exact_orbit(&self, case: &Case) -> Option<Seed> {
        let Dynamics::Smoothed(_) = case.dynamics else {
            return None;
        };
        let exact = Case {
            dynamics: Dynamics::Exact,
            along: None,
            ..case.clone()
        };
        let orbit = self.sought(&exact).ok()?.orbit(0.0).ok()?;
        Some(Seed {
            start: orbit.place.state,
            period: Some(orbit.period),
            settles: false,
        })
    }

    /// An error that names an equilibrium, with its exact place where Newton finds it.
    pub(in crate::study) fn sharpened(&self, case: &Case, error: OrbitError) -> OrbitError {
        let (OrbitError::Equilibrium { state: near }, Ok(flow)) = (&error, self.at(case)) else {
            return error;
        };
        let starts = std::slice::from_ref(&**near);
        let modes = |y: &[f64]| sliding_modes(flow.as_ref(), self.info(), y);
        let found = find(&self.family(case), self.beginning(case), starts, modes);
        let size = near.iter().fold(1.0_f64, |size, y| size.max(y.abs()));
        let close = |place: &&Vec<f64>| {
            let off = place.iter().zip(near.iter()).map(|(a, b)| (a - b).abs());
            off.fold(0.0, f64::max) <= SETTLED * size
        };
        match found.iter().map(|one| &one.place.state).find(close) {
            Some(state) => {
                let rounding = vec![f64::EPSILON * size; state.len()];
                OrbitError::Equilibrium {
                    state: flow.values(state).within(rounding),
                }
            }
            None => error,
        }
    }
}

/// The seeds without those that are there already: many contacts at rest have many that are one.
fn different(seeds: Vec<Seed>) -> Vec<Seed> {
    let mut kept: Vec<Seed> = Vec::new();
    for seed in seeds {
        if !kept.contains(&seed) {
            kept.push(seed);
        }
    }
    kept
}

impl Sought<'_> {
    /// Says from where an orbit is looked for.
    fn tell(&self, number: usize, seed: &Seed) {
        self.system.tell(|| {
            let from = Values::of(self.system.info(), &seed.start);
            let how = match seed.period {
                Some(period) => format!("by Newton's method with the period {}", brief(period)),
                None if seed.settles => "where the motion settles".to_owned(),
                None => "near returns of the motion".to_owned(),
            };
            format!(
                "from {from} ({} of {}), {how}",
                number + 1,
                self.seeds.len()
            )
        });
    }

    /// The orbit at r, in the family's own count, from the first seed that leads to one.
    pub(in crate::study) fn orbit(&self, r: f64) -> Result<Orbit, OrbitError> {
        let mut telling = None::<OrbitError>;
        for (number, seed) in self.seeds.iter().enumerate() {
            self.tell(number, seed);
            let search = Search {
                start: seed.start.clone(),
                period: seed.period,
                ..self.search.clone()
            };
            let find = if seed.settles { settled } else { closest };
            match find(&self.family, r, &search) {
                Ok(orbit) => return Ok(orbit),
                Err(error) => {
                    // Of failures that tell as much, that of the declared start is what was asked about.
                    let meant = seed.start == self.search.start;
                    let (least, own) = (telling.as_ref().map(tells), tells(&error));
                    if least.is_none_or(|least| least < own || (least == own && meant)) {
                        telling = Some(error);
                    }
                }
            }
        }
        Err(telling.map_or(
            OrbitError::NotSettled {
                time: 0.0,
                last: None,
                reached: self.search.start.clone(),
                exponent: None,
            },
            |error| self.parting(r, error),
        ))
    }

    /// A motion that has not settled with its Lyapunov exponent.
    fn parting(&self, r: f64, mut error: OrbitError) -> OrbitError {
        if let OrbitError::NotSettled {
            time,
            reached,
            exponent,
            ..
        } = &mut error
        {
            let tolerance = Tolerance::for_accuracy(ROUGH);
            let flow = self.family.with_tolerance(tolerance).at(r).ok();
            *exponent = flow.and_then(|flow| {
                let place = flow.place(reached).ok()?;
                let found = lyapunov(flow.as_ref(), place, LAP * *time, LAPS).ok()?;
                (found.exponent?.is_finite() && found.error.is_finite()).then_some(found)
            });
        }
        error
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nowhere_is_begun_twice() {
        let [here, there] = [0.0, 1.0].map(|x| Seed::at(vec![x]));
        let settling = Seed {
            settles: true,
            ..here.clone()
        };
        let asked = vec![here.clone(), there.clone(), here.clone(), settling.clone()];
        assert_eq!(different(asked), [here, there, settling]);
    }
}

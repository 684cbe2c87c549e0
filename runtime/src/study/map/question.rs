//! What can be asked at a node.

use std::ops::ControlFlow;

use super::cell::Cell;
use crate::field::Smoothing;
use crate::motion::half_extents;
use crate::study::attractors::{Attractor, Class, Region, Sampling, closely};
use crate::study::question::Case;
use crate::study::system::System;
use crate::study::work::List;
use crate::words::words;

words! {
    /// A number that a motion has.
    pub enum Quantity {
        /// Its period.
        Period = "period",
        /// Half the extent of a state.
        Amplitude = "amplitude",
        /// The largest modulus of its multipliers.
        Multiplier = "multiplier",
        /// The largest Lyapunov exponent across it.
        Exponent = "exponent",
    }
}

/// A question for every node.
#[derive(Debug, Clone, PartialEq)]
pub enum Asked {
    /// On what the start settles.
    Motion,
    /// A number of that motion; of an amplitude, that of the state of this index.
    Quantity(Quantity, usize),
    /// Whether the equilibrium is stable: the largest real part of its eigenvalues.
    Equilibrium,
    /// The share of a region from which motions of this class settle, by so many starts.
    Share(Class, Region, usize),
    /// The error of the frequency of an orbit that this smoothing would make, as it is predicted.
    Smoothing(Smoothing),
}

impl Asked {
    /// The answer for a case in which nothing is followed.
    pub(super) fn of(&self, system: &System, case: &Case) -> Cell {
        let answer = match self {
            Self::Motion => closely(system, case).map(|found| motion(found, |_| None)),
            Self::Quantity(quantity, state) => {
                closely(system, case).map(|found| motion(found, |one| quantity.of(one, *state)))
            }
            Self::Equilibrium => Ok(equilibrium(system, case)),
            Self::Share(class, region, starts) => {
                Ok(share(system, case, *class, (region, *starts)))
            }
            Self::Smoothing(smoothing) => Ok(smoothed(system, case, *smoothing)),
        };
        answer.unwrap_or_else(|error| Cell::failed(error.to_string()))
    }
}

fn motion(found: Attractor, value: impl Fn(&Attractor) -> Option<f64>) -> Cell {
    Cell {
        kind: found.name(),
        value: value(&found),
        reason: found.reason.clone(),
        motion: Some(Box::new(found)),
    }
}

fn equilibrium(system: &System, case: &Case) -> Cell {
    match system.equilibria(case) {
        Ok(found) => {
            let first = found.first();
            let value = first.and_then(|one| Some(one.eigenvalues.first()?.re));
            let name = |mode: &Option<String>| {
                mode.as_ref()
                    .map_or(String::new(), |mode| format!(" {mode}"))
            };
            let kind = first.map_or(String::new(), |one| {
                format!("{}{}", one.stability, name(&one.mode))
            });
            Cell::number(kind, value)
        }
        Err(error) => Cell::failed(error.to_string()),
    }
}

fn share(system: &System, case: &Case, class: Class, (region, starts): (&Region, usize)) -> Cell {
    let list = List::on_one_thread();
    let sampling = Sampling::of(region.clone(), starts);
    let found = system.attractors_watched(case, &sampling, &list, &|_| ControlFlow::Continue(()));
    match found {
        Ok(record) => {
            let all = record.surveys.iter().flat_map(|survey| &survey.found);
            let kinds: Vec<String> = all.clone().map(|one| one.attractor.name()).collect();
            let wanted = all.filter(|one| one.attractor.class == class);
            Cell::number(kinds.join(", "), Some(wanted.map(|one| one.share).sum()))
        }
        Err(error) => Cell::failed(error.to_string()),
    }
}

fn smoothed(system: &System, case: &Case, smoothing: Smoothing) -> Cell {
    let orbit = system.sought(case).map_err(|error| error.to_string());
    let orbit = orbit.and_then(|sought| sought.orbit(0.0).map_err(|error| error.to_string()));
    let predicted = orbit.and_then(|orbit| {
        let predicted = system.predict(case, &orbit, smoothing);
        predicted.map_err(|error| error.to_string())
    });
    match predicted {
        Ok(predicted) => {
            let kind = if predicted.doubts.is_empty() {
                "predicted"
            } else {
                "doubtful"
            };
            Cell {
                reason: predicted.doubts.first().cloned(),
                ..Cell::number(kind, Some(predicted.frequency))
            }
        }
        Err(error) => Cell::failed(error),
    }
}

impl Quantity {
    /// Its value for a motion that has one.
    fn of(self, found: &Attractor, state: usize) -> Option<f64> {
        let [re, im] = found.multipliers.first().copied().unwrap_or([f64::NAN; 2]);
        let cycle = matches!(found.class, Class::Orbit | Class::Running) && found.period.is_some();
        let value = match self {
            Self::Period => found.period?,
            Self::Amplitude if found.min == found.max => 0.0,
            Self::Amplitude => {
                let order = found.min.len();
                half_extents(&found.min, &found.max, &vec![0.0; order])
                    .get(state)
                    .copied()?
            }
            Self::Multiplier if cycle => re.hypot(im),
            Self::Exponent if cycle => re.hypot(im).ln() / found.period?,
            Self::Exponent => found.exponent.map_or(re, |[exponent, _]| exponent),
            Self::Multiplier => return None,
        };
        value.is_finite().then_some(value)
    }
}

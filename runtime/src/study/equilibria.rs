//! The equilibria of a declared model: of its exact system, of its copies, and what the one says of the other.

use std::ops::ControlFlow;

use super::branch::Ended;
use super::case::{Along, Case, Dynamics};
use super::counterpart::Counterpart;
use super::declared::Declared;
use super::entry::StudyError;
use super::equilibrium::{EquilibriaRecord, EquilibriumRecord, Extent, SpecialEquilibrium};
use super::modes::{sliding_mode, sliding_modes, spelt, sticking_modes};
use crate::equilibrium::{
    Branch, Confined, End, Equilibrium, Found, Kind, Proof, Spectrum, Spot, StickingSet, Unproven,
    find, follow, prove, settings, starts, sticking_sets,
};
use crate::field::EnclosedField;
use crate::flow::{Family, Flow, Place};
use crate::model::Model;

/// Told of each point of a branch.
pub(super) type Watch<'a> = &'a mut dyn FnMut(&EquilibriumRecord) -> ControlFlow<()>;

impl<M: Model<N>, const N: usize> Declared<M, N> {
    /// Every equilibrium that is found, and for exact dynamics every set of sticking ones.
    pub(super) fn all_equilibria(case: &Case) -> Result<Vec<EquilibriumRecord>, StudyError> {
        let places = starts(Self::start(case));
        let r = Self::beginning(case);
        let found = match case.dynamics {
            Dynamics::Exact if const { Self::RUBS } => {
                let model = Self::model(case);
                let sliding = find(&Self::exact(case), r, &places, |y| sliding_modes(&model, y));
                let sets = sticking_sets(&model, &places, &sticking_modes())?;
                let sliding = sliding
                    .iter()
                    .map(|one| record(case, one, spelt(one.place.mode)));
                let sets = sets.iter().map(|set| set_record(case, set));
                sliding.chain(sets).collect()
            }
            _ => {
                let found = find(&Self::smooth(case), r, &places, |_| vec![()]);
                let records = found.iter().map(|one| record(case, one, None));
                records
                    .map(|record| Self::compared(case, record))
                    .collect::<Vec<_>>()
            }
        };
        if found.is_empty() {
            return Err(StudyError::NoEquilibrium {
                starts: places.len(),
            });
        }
        Ok(found)
    }

    /// Follows the first equilibrium that is found.
    pub(super) fn equilibria_along(
        case: &Case,
        along: Along,
        watch: Watch<'_>,
    ) -> Result<EquilibriaRecord, StudyError> {
        match case.dynamics {
            Dynamics::Exact if const { Self::RUBS } => {
                let model = Self::model(case);
                let modes = |y: &[f64; N]| sliding_modes(&model, y);
                let spelt = |mode| spelt::<M, N>(mode);
                let family = Self::exact(case);
                let first = Self::first(case, &family, modes)?;
                Self::followed(case, along, &family, (&first, spelt(first.mode)), watch)
            }
            _ => {
                let family = Self::smooth(case);
                let first = Self::first(case, &family, |_| vec![()])?;
                let mut branch = Self::followed(case, along, &family, (&first, None), watch)?;
                if const { Self::RUBS } {
                    let exact = Counterpart::<M, N>::new(case);
                    for point in &mut branch.special {
                        point.artefact = exact.lacks(along, point);
                    }
                }
                Ok(branch)
            }
        }
    }

    /// A proof that the equilibrium exists, in the mode in which its contacts slide there.
    pub(super) fn proof(case: &Case, found: &EquilibriumRecord) -> Result<Proof, Unproven> {
        let model = Self::model(case);
        let state: [f64; N] =
            std::array::from_fn(|j| found.state.get(j).copied().unwrap_or(f64::NAN));
        let field = match case.dynamics {
            Dynamics::Exact if const { Self::RUBS } => {
                EnclosedField::sliding(&model, sliding_mode(&model, &state))
            }
            _ => EnclosedField::smooth(&model, case.smoothing()),
        };
        prove(&field, &state)
    }

    fn first<F: Family<N> + Clone>(
        case: &Case,
        family: &F,
        modes: impl Fn(&[f64; N]) -> Vec<<F::Flow as Flow<N>>::Mode>,
    ) -> Result<Place<N, <F::Flow as Flow<N>>::Mode>, StudyError>
    where
        F::Flow: Confined<N>,
    {
        let places = starts(Self::start(case));
        let found = places
            .iter()
            .find_map(|start| find(family, Self::beginning(case), &[*start], &modes).pop());
        let none = StudyError::NoEquilibrium {
            starts: places.len(),
        };
        found.map(|first| first.place).ok_or(none)
    }

    fn followed<F: Family<N> + Clone>(
        case: &Case,
        along: Along,
        family: &F,
        (first, mode): (&Place<N, <F::Flow as Flow<N>>::Mode>, Option<String>),
        watch: Watch<'_>,
    ) -> Result<EquilibriaRecord, StudyError>
    where
        F::Flow: Confined<N>,
    {
        let (from, to) = along.span();
        let mut points = Vec::new();
        let mut take = |spot: &Spot<N>| {
            let at = case.at(along.value(spot.r));
            let point = EquilibriumRecord {
                r: Some(along.value(spot.r)),
                ..plain(&at, spot.state.to_vec(), &spot.spectrum, mode.clone())
            };
            let point = Self::compared(&at, point);
            let verdict = watch(&point);
            points.push(point);
            verdict
        };
        let branch = follow(family, first, settings(from, to), &mut take)
            .map_err(StudyError::Equilibrium)?;
        Ok(EquilibriaRecord {
            along,
            special: numbered(along, &branch.special),
            ended: ended::<M, N>(&branch),
            work: branch.work,
            points,
        })
    }

    /// The record of an equilibrium of a copy, compared with the exact system.
    fn compared(case: &Case, mut record: EquilibriumRecord) -> EquilibriumRecord {
        if const { Self::RUBS } && case.smoothing().is_some() {
            record.artefact = Counterpart::<M, N>::new(case).differs(&record);
        }
        record
    }
}

fn numbered<const N: usize>(along: Along, found: &[Found<N>]) -> Vec<SpecialEquilibrium> {
    let label = |i: usize| {
        let kind = found[i].kind;
        let number = found[..=i]
            .iter()
            .filter(|other| other.kind == kind)
            .count();
        format!("{}{number}", kind.letters())
    };
    let special = |(i, Found { kind, spot }): (usize, &Found<N>)| {
        let frequency = spot.spectrum.critical_frequency();
        let frequency = frequency.filter(|_| *kind == Kind::Hopf);
        SpecialEquilibrium {
            kind: kind.name(),
            label: label(i),
            r: along.value(spot.r),
            state: spot.state.to_vec(),
            eigenvalues: spot.spectrum.eigenvalues.clone(),
            period: frequency.map(|omega| std::f64::consts::TAU / omega),
            artefact: false,
        }
    };
    found.iter().enumerate().map(special).collect()
}

fn ended<M: Model<N>, const N: usize>(branch: &Branch<N>) -> Ended {
    match &branch.end {
        End::Followed(ending) => Ended::from(ending),
        End::Stopped => Ended::interrupted(),
        End::Boundary(contact) => {
            let name = M::INFO
                .contacts
                .get(*contact)
                .map_or("?", |contact| contact.name);
            Ended {
                word: Kind::BoundaryEquilibrium.name(),
                located: true,
                reason: format!(
                    "the relative speed of `{name}` reaches zero, and with it this way of sliding ends"
                ),
            }
        }
        End::Unexplained(from, to) => Ended {
            word: "unexplained-change",
            located: false,
            reason: format!(
                "its stability changes between {from} and {to}, and no bifurcation was found there"
            ),
        },
    }
}

fn plain(
    case: &Case,
    state: Vec<f64>,
    spectrum: &Spectrum,
    mode: Option<String>,
) -> EquilibriumRecord {
    EquilibriumRecord {
        r: None,
        parameters: case.parameters.clone(),
        dynamics: case.dynamics,
        state,
        eigenvalues: spectrum.eigenvalues.clone(),
        stability: spectrum.stability,
        mode,
        set: None,
        artefact: false,
    }
}

fn record<Mode, const N: usize>(
    case: &Case,
    found: &Equilibrium<N, Mode>,
    mode: Option<String>,
) -> EquilibriumRecord {
    plain(case, found.place.state.to_vec(), &found.spectrum, mode)
}

fn set_record<M: Model<N>, const N: usize>(
    case: &Case,
    set: &StickingSet<M, N>,
) -> EquilibriumRecord {
    let extent = Extent {
        dimension: set.dimension,
        low: set.low.to_vec(),
        high: set.high.to_vec(),
    };
    EquilibriumRecord {
        set: (set.dimension > 0).then_some(extent),
        ..plain(case, set.state.to_vec(), &set.spectrum, spelt(set.mode))
    }
}

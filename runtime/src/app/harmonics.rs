//! `--harmonics`: amplitudes and phases of orbits.

use clap::Args;
use serde_json::{Map, Value, json};

use super::document::{Document, named};
use super::failure::{Failure, refuse};
use super::spreadsheet::Columns;
use super::text::{digits, label, line, number, table, unit};
use super::values::Reading;
use super::words::count;
use crate::harmonics::Harmonic;
use crate::model::ModelInfo;
use crate::study::{Case, OrbitRecord, StudyError, System};

/// Harmonics beyond this are no numbers of a motion any more.
const HIGHEST: usize = 1000;

#[derive(Debug, Clone, Args)]
pub(super) struct Harmonics {
    /// Amplitude and phase at these multiples of the drive's frequency (of the orbit's, without a drive): `1,3`; with a drive 1 if nothing is said
    #[arg(long, value_name = "H,..", value_parser = Reading(Orders::read))]
    harmonics: Option<Orders>,
}

/// Accuracies to which harmonics are counted.
const ACCURACIES: [f64; 3] = [1e-2, 1e-3, 1e-4];

/// How many harmonics the series of each state takes for each of the accuracies, or why that is not known.
pub(super) type Series = Result<Vec<Vec<Option<usize>>>, StudyError>;

/// Multiples of a frequency.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Orders(Vec<usize>);

impl Orders {
    /// `1,3`.
    fn read(option: &str, word: &str) -> Result<Self, Failure> {
        let mut orders = Vec::new();
        for one in word.split(',') {
            let order = count(option, one, [1, HIGHEST])?;
            if orders.contains(&order) {
                return refuse!("`{option} {word}` names {order} more than once");
            }
            orders.push(order);
        }
        Ok(Self(orders))
    }
}

impl Harmonics {
    /// Those that are asked for; of a driven model at least the fundamental.
    pub(super) fn of(&self, info: &ModelInfo) -> Vec<usize> {
        let usual = || info.drive.map_or_else(Vec::new, |_| vec![1]);
        let given = self.harmonics.as_ref();
        given.map_or_else(usual, |orders| orders.0.clone())
    }
}

impl Harmonics {
    /// How many there are to speak of in an orbit, if harmonics are asked for.
    pub(super) fn series(
        &self,
        system: &System,
        case: &Case,
        orbit: &OrbitRecord,
    ) -> Option<Series> {
        let asked = self.harmonics.is_some();
        asked.then(|| system.series(case, orbit, &ACCURACIES))
    }
}

/// The states that have harmonics: all but the phase of the drive.
fn swinging(info: &ModelInfo) -> impl Iterator<Item = usize> {
    let phase = info.drive;
    (0..info.states.len()).filter(move |j| Some(*j) != phase)
}

/// The harmonic of this order, as far as it is known.
pub(super) fn harmonic(orbit: &OrbitRecord, order: usize) -> Option<&Harmonic> {
    let known = orbit.harmonics.as_ref().ok()?;
    known.iter().find(|harmonic| harmonic.order == order)
}

/// The names of the amplitude and the phase of a state, with their units.
pub(super) fn names(info: &ModelInfo, order: usize, state: usize) -> [String; 2] {
    let of = info.states.get(state);
    let name = of.map_or("", |state| state.name);
    let amplitude = label(
        &format!("amplitude_{order} {name}"),
        of.and_then(|state| state.unit),
    );
    [amplitude, format!("phase_{order} {name} (rad)")]
}

/// These columns, and those of these harmonics: amplitude, phase and error of each state; empty where they are not known.
pub(super) fn all(
    columns: Columns<'static, OrbitRecord>,
    info: &ModelInfo,
    orders: &[usize],
) -> Columns<'static, OrbitRecord> {
    let places = orders
        .iter()
        .flat_map(|&order| swinging(info).map(move |j| (order, j)));
    places.fold(columns, |columns, (order, j)| {
        let value = move |values: fn(&Harmonic) -> &[f64]| {
            move |orbit: &OrbitRecord| values(harmonic(orbit, order)?).get(j).copied()
        };
        let state = &info.states[j];
        let error = label(&format!("error_{order} {}", state.name), state.unit);
        let [amplitude, phase] = names(info, order, j);
        columns
            .number(amplitude, value(|one| &one.amplitude))
            .number(phase, value(|one| &one.phase))
            .number(error, value(|one| &one.error))
    })
}

/// These columns, and those of amplitude and phase of a state in the digits that they deserve.
pub(super) fn rounded(
    columns: Columns<'static, OrbitRecord>,
    info: &ModelInfo,
    order: usize,
    j: usize,
) -> Columns<'static, OrbitRecord> {
    let cell = move |part: usize| {
        move |orbit: &OrbitRecord| {
            let known = harmonic(orbit, order);
            known.map_or_else(String::new, |one| shown(one, j)[part].clone())
        }
    };
    let [amplitude, phase] = names(info, order, j);
    columns.column(amplitude, cell(0)).column(phase, cell(1))
}

/// The harmonics as JSON, if any were wanted; the reason where they are not known.
pub(super) fn document(info: &ModelInfo, orbit: &OrbitRecord) -> Option<Value> {
    let one = |harmonic: &Harmonic| -> Value {
        let of = |values: &[f64]| {
            let names = swinging(info).map(|j| info.states[j].name);
            named(names, swinging(info).map(|j| values[j]))
        };
        Document::new(info)
            .put("order", harmonic.order)
            .put("amplitude", of(&harmonic.amplitude))
            .put("phase", of(&harmonic.phase))
            .put("error", of(&harmonic.error))
            .into()
    };
    match &orbit.harmonics {
        Ok(known) if known.is_empty() => None,
        Ok(known) => Some(known.iter().map(one).collect()),
        Err(error) => Some(error.to_string().into()),
    }
}

/// The harmonics as the lines of a table.
pub(super) fn lines(info: &ModelInfo, orbit: &OrbitRecord) -> String {
    let known = match &orbit.harmonics {
        Ok(known) if known.is_empty() => return String::new(),
        Ok(known) => known,
        Err(error) => return format!("harmonics\tnone: {error}\n"),
    };
    let mut lines = "harmonic\tstate\tamplitude\tphase\n".to_owned();
    for harmonic in known {
        for j in swinging(info) {
            let state = &info.states[j];
            let [amplitude, phase] = shown(harmonic, j);
            let of = unit(state.unit);
            lines += &format!(
                "{}\t{}\t{amplitude}{of}\t{phase} rad\n",
                harmonic.order, state.name
            );
        }
    }
    lines
}

/// How many suffice, as text.
pub(super) fn counted(info: &ModelInfo, series: &Series) -> String {
    let counts = match series {
        Ok(counts) => counts,
        Err(error) => return format!("\n  harmonics are not counted: {error}\n"),
    };
    let head = ACCURACIES.map(|accuracy| number(accuracy, 1));
    let mut lines = line(["harmonics for".to_owned()].into_iter().chain(head));
    for j in swinging(info) {
        let name = info.states[j].name.to_owned();
        let count = |count: &Option<usize>| count.map_or("more".to_owned(), |one| one.to_string());
        lines += &line([name].into_iter().chain(counts[j].iter().map(count)));
    }
    format!("\n{}", table(&lines))
}

/// How many suffice, as JSON.
pub(super) fn counts(info: &ModelInfo, series: &Series) -> Value {
    let counts = match series {
        Ok(counts) => counts,
        Err(error) => return error.to_string().into(),
    };
    let one = |(i, accuracy): (usize, &f64)| {
        let of = |j: usize| (info.states[j].name.to_owned(), counts[j][i].into());
        let harmonics: Map<String, Value> = swinging(info).map(of).collect();
        json!({ "accuracy": accuracy, "harmonics": harmonics })
    };
    ACCURACIES.iter().enumerate().map(one).collect()
}

/// Amplitude and phase of a state in the digits that they deserve; an amplitude within its error has no phase.
fn shown(harmonic: &Harmonic, j: usize) -> [String; 2] {
    let (amplitude, error) = (harmonic.amplitude[j], harmonic.error[j]);
    if amplitude <= error {
        return ["0".to_owned(), "-".to_owned()];
    }
    let digits = digits(error / amplitude).min(9);
    [amplitude, harmonic.phase[j]].map(|value| number(value, digits))
}

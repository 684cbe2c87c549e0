//! `--harmonics`: amplitudes and phases of orbits.

use clap::Args;
use serde_json::Value;

use super::document::Document;
use super::failure::{Failure, refuse};
use super::spreadsheet::{Row, optional};
use super::text::{label, number, unit};
use super::values::Reading;
use super::words::count;
use crate::harmonics::Harmonic;
use crate::model::ModelInfo;
use crate::study::OrbitRecord;

/// Harmonics beyond this are no numbers of a motion any more.
const HIGHEST: usize = 1000;

#[derive(Debug, Clone, Args)]
#[group(skip)]
pub(super) struct Harmonics {
    /// Amplitude and phase at these multiples of the drive's frequency (of the orbit's, without a drive): `1,3`; with a drive 1 if nothing is said
    #[arg(long, value_name = "H,..", value_parser = Reading(Orders::read))]
    harmonics: Option<Orders>,
}

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

/// The columns of these harmonics: amplitude, phase and error of each state.
pub(super) fn head(info: &ModelInfo, orders: &[usize]) -> Row {
    let mut row = Row::new();
    for &order in orders {
        for j in swinging(info) {
            let state = &info.states[j];
            row.extend(names(info, order, j));
            row.push(label(&format!("error_{order} {}", state.name), state.unit));
        }
    }
    row
}

/// Amplitude, phase and error of each state; empty where they are not known.
pub(super) fn row(orbit: &OrbitRecord, phase: Option<usize>, orders: &[usize]) -> Row {
    let mut row = Row::new();
    for &order in orders {
        let known = harmonic(orbit, order);
        for j in (0..orbit.state.len()).filter(|j| Some(*j) != phase) {
            let value = |values: fn(&Harmonic) -> &[f64]| optional(known.map(|one| values(one)[j]));
            row.push(value(|one| &one.amplitude));
            row.push(value(|one| &one.phase));
            row.push(value(|one| &one.error));
        }
    }
    row
}

/// The harmonics as JSON, if any were wanted; the reason where they are not known.
pub(super) fn document(info: &ModelInfo, orbit: &OrbitRecord) -> Option<Value> {
    let one = |harmonic: &Harmonic| -> Value {
        let of = |values: &[f64]| {
            let states = swinging(info).map(|j| (info.states[j].name.to_owned(), values[j].into()));
            Value::Object(states.collect())
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

/// Amplitude and phase of a state in the digits that they deserve; an amplitude within its error has no phase.
pub(super) fn shown(harmonic: &Harmonic, j: usize) -> [String; 2] {
    let (amplitude, error) = (harmonic.amplitude[j], harmonic.error[j]);
    if amplitude <= error {
        return ["0".to_owned(), "-".to_owned()];
    }
    let digits = super::text::digits(error / amplitude).min(9);
    [amplitude, harmonic.phase[j]].map(|value| number(value, digits))
}

//! `--section`: which points of a motion are looked at.

use clap::ArgMatches;

use super::failure::Failure;
use super::options::text;
use super::text::{label, number, table, time_unit};
use super::words::{assignment, number as numeral, unknown};
use crate::model::ModelInfo;
use crate::poincare::Crossing;
use crate::poincare::{Direction, Section, Surface};

/// Digits shown of a point.
const DIGITS: usize = 9;

/// The section that is asked for, if any is.
pub(super) fn section(info: &ModelInfo, options: &ArgMatches) -> Result<Option<Section>, Failure> {
    text(options, "section")
        .map(|word| parse(info, word))
        .transpose()
}

/// `v=0.1`, `v=0.1 down`, `der(x)=0`.
fn parse(info: &ModelInfo, word: &str) -> Result<Section, Failure> {
    let (name, rest) = assignment("--section", word)?;
    let mut words = rest.split_whitespace();
    let value = words.next().unwrap_or_default();
    let direction = words.next().map_or(Ok(Direction::Up), direction)?;
    if let Some(more) = words.next() {
        return Err(Failure::usage(format!(
            "`--section {word}`: `{more}` is one word too many: write a value and `up`, `down` or `both`"
        )));
    }
    let value = numeral(&format!("--section {word}"), value)?;
    let inner = name
        .strip_prefix("der(")
        .and_then(|name| name.strip_suffix(')'));
    let surface = match inner {
        None => Surface::Level {
            state: state(info, name)?,
            value,
        },
        Some(inner) if value == 0.0 => Surface::Rate(state(info, inner.trim())?),
        Some(inner) => {
            state(info, inner.trim())?;
            return Err(Failure::usage(format!(
                "`--section {word}`: a rate is looked at where it vanishes: write `{name}=0`"
            )));
        }
    };
    Ok(Section { surface, direction })
}

fn state(info: &ModelInfo, name: &str) -> Result<usize, Failure> {
    let place = info.states.iter().position(|state| state.name == name);
    place.ok_or_else(|| {
        let names: Vec<&str> = info.states.iter().map(|state| state.name).collect();
        let what = format!("`{}` has no state", info.command);
        Failure::usage(unknown(&what, name, &names))
    })
}

fn direction(word: &str) -> Result<Direction, Failure> {
    let all = [Direction::Up, Direction::Down, Direction::Both];
    let found = all.into_iter().find(|direction| direction.name() == word);
    found.ok_or_else(|| {
        let what = "`--section` knows no direction";
        Failure::usage(unknown(what, word, &all.map(Direction::name)))
    })
}

/// The points as a table, under a line that says where they lie.
pub(super) fn describe(info: &ModelInfo, section: &Section, points: &[Crossing]) -> String {
    let count = match points.len() {
        1 => "1 point".to_owned(),
        count => format!("{count} points"),
    };
    let mut text = format!("\n  section {}: {count}\n", section.describe(info));
    if points.is_empty() {
        return text;
    }
    let time = format!("t{}", bracketed(time_unit(info)));
    let states = info
        .states
        .iter()
        .map(|state| label(state.name, state.unit));
    let mut rows = vec![std::iter::once(time).chain(states).collect::<Vec<_>>()];
    rows.extend(points.iter().map(|point| {
        let values = std::iter::once(&point.time).chain(&point.state);
        values.map(|&value| number(value, DIGITS)).collect()
    }));
    text.push_str(&table(&rows));
    text
}

fn bracketed(unit: &str) -> String {
    match unit.trim() {
        "" => String::new(),
        unit => format!(" ({unit})"),
    }
}

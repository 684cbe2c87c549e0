//! `--start`: values, or `FILE.json`: where something begins that was found before, with the parameters and the friction
//! that it had.

use std::path::PathBuf;

use serde_json::Value;

use super::failure::{Failure, refuse};
use super::values::{Assignment, SMOOTH};
use crate::field::Smoothing;
use crate::field::exact::Mode;
use crate::model::{ModelInfo, within_reach};
use crate::motion::Modes;
use crate::study::Dynamics;

/// Where to begin.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Start {
    /// `name=value,...`, each name once.
    Given(Vec<Assignment>),
    /// What a file holds.
    Saved(Named),
}

impl Start {
    pub(super) fn read(option: &str, word: &str) -> Result<Self, Failure> {
        if let Some(named) = Named::read(word) {
            return Ok(Self::Saved(named));
        }
        let mut given: Vec<Assignment> = Vec::new();
        for pair in word.split(',') {
            let one = Assignment::read(option, pair)?;
            if given.iter().any(|other| other.name == one.name) {
                return refuse!("`{option} {word}` gives `{}` more than once", one.name);
            }
            given.push(one);
        }
        Ok(Self::Given(given))
    }
}

/// A file with an answer, and which part of it is meant.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Named {
    word: String,
    file: PathBuf,
    /// The label of a special point, or the number of a row, if need be after `branch-1/`.
    part: Option<String>,
}

/// Where something begins that was found before.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Saved {
    pub(super) state: Vec<f64>,
    /// The modes in which it was reached; none where they are not known.
    pub(super) modes: Modes,
    pub(super) period: Option<f64>,
    /// Values of parameters, by their numbers.
    pub(super) parameters: Vec<(usize, f64)>,
    pub(super) dynamics: Option<Dynamics>,
}

impl Named {
    /// `FILE.json`, `FILE.json#PD1`, `FILE.json#3`; `None` if the word is no such name.
    pub(super) fn read(word: &str) -> Option<Self> {
        let (file, part) = match word.rsplit_once(".json#") {
            Some((name, part)) => (format!("{name}.json"), Some(part.to_owned())),
            None => (word.to_owned(), None),
        };
        file.ends_with(".json").then(|| Self {
            word: word.to_owned(),
            file: file.into(),
            part,
        })
    }

    /// What is there.
    ///
    /// # Errors
    /// The file cannot be read, belongs to another model, or has no such part.
    pub(super) fn of(&self, info: &ModelInfo) -> Result<Saved, Failure> {
        let found = std::fs::read(&self.file).map_err(|error| error.to_string());
        let found = found.and_then(|text| {
            serde_json::from_slice::<Value>(&text)
                .map_err(|error| format!("it is no JSON: {error}"))
        });
        let document = found.or_else(|reason| self.refuse(&format!("cannot be read: {reason}")))?;
        match document["model"].as_str() {
            Some(model) if model == info.command => {}
            Some(model) => {
                return self.refuse(&format!("belongs to `{model}`, not to `{}`", info.command));
            }
            None => return self.refuse("is no answer of this program: it names no model"),
        }
        let part = self.part(&document)?;
        let saved = Saved {
            state: self.state(info, part)?,
            modes: modes(info, part).unwrap_or_default(),
            period: positive(&part["period"]),
            parameters: parameters(info, &document, part),
            dynamics: dynamics(&document, part),
        };
        Ok(saved)
    }

    fn refuse<T>(&self, reason: &str) -> Result<T, Failure> {
        refuse!("`--start {}`: the file {reason}", self.word)
    }

    /// The part that is meant: the whole, a row, or a special point.
    fn part<'a>(&self, document: &'a Value) -> Result<&'a Value, Failure> {
        let Some(part) = &self.part else {
            return match &document["state"] {
                Value::Object(_) => Ok(document),
                _ => self.refuse(&format!(
                    "holds {}: say which one",
                    there(document, &self.file)
                )),
            };
        };
        let (branch, label) = match part.split_once('/') {
            Some((branch, label)) => (Some(branch), label),
            None => (None, part.as_str()),
        };
        let number = branch.map_or(Some(0), |name| name.strip_prefix("branch-")?.parse().ok());
        let branch = number.and_then(|number: usize| branches(document).into_iter().nth(number));
        let found = branch.and_then(|branch| match label.parse::<usize>() {
            Ok(row) => rows(branch).get(row.checked_sub(1)?),
            Err(_) => special(branch).find(|one| {
                let known = one["label"].as_str();
                known.is_some_and(|known| known.eq_ignore_ascii_case(label))
            }),
        });
        match found {
            Some(found) => Ok(found),
            None => self.refuse(&format!(
                "has no `{part}`, but {}",
                there(document, &self.file)
            )),
        }
    }

    /// The value of each state.
    fn state(&self, info: &ModelInfo, part: &Value) -> Result<Vec<f64>, Failure> {
        let value = |name: &str| match number(&part["state"][name]) {
            Some(value) => Ok(value),
            None => self.refuse(&format!("has no value of `{name}` there")),
        };
        info.states.iter().map(|state| value(state.name)).collect()
    }
}

/// The mode of each contact; `None` where one is not known.
fn modes(info: &ModelInfo, part: &Value) -> Option<Modes> {
    let mode = |(name, _)| Mode::named(part["modes"].get(name)?.as_str()?);
    info.forces().map(mode).collect()
}

/// A number with which a model can be asked.
fn number(value: &Value) -> Option<f64> {
    value.as_f64().filter(|value| within_reach(*value))
}

fn positive(value: &Value) -> Option<f64> {
    number(value).filter(|value| *value > 0.0)
}

/// A branch, and all that leave it, in the order of their tables.
fn branches(branch: &Value) -> Vec<&Value> {
    let below = branch["branches"].as_array();
    let below = below.into_iter().flatten().flat_map(branches);
    std::iter::once(branch).chain(below).collect()
}

fn rows(branch: &Value) -> &[Value] {
    let rows = ["points", "equilibria"].map(|name| branch[name].as_array());
    rows.into_iter().flatten().next().map_or(&[], Vec::as_slice)
}

fn special(branch: &Value) -> impl Iterator<Item = &Value> {
    branch["special"].as_array().into_iter().flatten()
}

/// What there is to begin from.
fn there(document: &Value, file: &std::path::Path) -> String {
    let rows = rows(document).len();
    let labels = special(document).filter_map(|one| one["label"].as_str());
    let name = file.display();
    let labels: Vec<String> = labels.map(|label| format!("{name}#{label}")).collect();
    match (rows, labels.as_slice()) {
        (0, []) => "nothing to begin from".to_owned(),
        (rows, []) => format!("{rows} rows, {name}#1 to {name}#{rows}"),
        (rows, labels) => format!(
            "{rows} rows, {name}#1 to {name}#{rows}, and {}",
            labels.join(", ")
        ),
    }
}

/// The parameters of a part: those of the whole, but for what was followed.
fn parameters(info: &ModelInfo, document: &Value, part: &Value) -> Vec<(usize, f64)> {
    let declared = info.parameters.iter().enumerate();
    let value = |name: &str| {
        let followed = document["along"]["name"].as_str() == Some(name);
        let here = followed.then(|| number(&part["r"])).flatten();
        here.or_else(|| number(&part["at"][name]))
            .or_else(|| number(&part["parameters"][name]))
            .or_else(|| number(&document["parameters"][name]))
    };
    declared
        .filter_map(|(index, declared)| Some((index, value(declared.name)?)))
        .collect()
}

/// How friction acted there.
fn dynamics(document: &Value, part: &Value) -> Option<Dynamics> {
    let word = [part, document].map(|one| one["dynamics"].as_str());
    let word = word.into_iter().flatten().next()?;
    if word == Dynamics::Exact.to_string() {
        return Some(Dynamics::Exact);
    }
    let smoothing: Smoothing = word.parse().ok()?;
    let followed = document["along"]["name"].as_str() == Some(SMOOTH);
    let size = followed.then(|| positive(&part["r"])).flatten();
    Some(Dynamics::Smoothed(Smoothing {
        size: size.unwrap_or(smoothing.size),
        ..smoothing
    }))
}

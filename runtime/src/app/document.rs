//! Answers as JSON: records, with names for the values that have one.

use serde::ser::{Serialize, Serializer};
use serde_json::{Map, Value, json};

use super::text::time_unit;
use crate::field::exact::Mode;
use crate::model::{ModelInfo, Unit};
use crate::study::{Along, Case, Ended};

/// An answer, its fields in the order in which they are put.
#[derive(Debug, Clone)]
pub(super) struct Document<'a> {
    info: &'a ModelInfo,
    fields: Map<String, Value>,
}

impl<'a> Document<'a> {
    /// Nothing yet.
    pub(super) fn new(info: &'a ModelInfo) -> Self {
        let fields = Map::new();
        Self { info, fields }
    }

    /// The fields of a record.
    pub(super) fn of(info: &'a ModelInfo, record: &impl Serialize) -> Self {
        Self::new(info).all(record)
    }

    /// The case that was asked.
    pub(super) fn case(info: &'a ModelInfo, case: &Case) -> Self {
        Self::new(info)
            .put("model", info.command)
            .put("dynamics", case.dynamics.to_string())
            .parameters(&case.parameters)
    }

    /// One more field.
    pub(super) fn put(mut self, name: &str, value: impl Serialize) -> Self {
        self.fields.insert(name.to_owned(), value_of(value));
        self
    }

    /// One more field, if it has a value.
    pub(super) fn maybe(self, name: &str, value: Option<impl Serialize>) -> Self {
        match value {
            Some(value) => self.put(name, value),
            None => self,
        }
    }

    /// One more field, a list of what `one` makes of each finding.
    pub(super) fn list<T, D: Serialize>(
        self,
        name: &str,
        findings: impl IntoIterator<Item = T>,
        one: impl FnMut(T) -> D,
    ) -> Self {
        self.put(name, findings.into_iter().map(one).collect::<Vec<_>>())
    }

    /// All fields of a record.
    pub(super) fn all(mut self, record: &impl Serialize) -> Self {
        if let Value::Object(fields) = value_of(record) {
            self.fields.extend(fields);
        }
        self
    }

    /// Values of all states, or of nothing else than there are names for.
    pub(super) fn states<T: Serialize>(
        self,
        name: &str,
        values: impl IntoIterator<Item = T>,
    ) -> Self {
        let states = self.info.states.iter();
        let named = named(states.map(|state| state.name), values);
        self.put(name, named)
    }

    /// Values of all states, if there are any.
    pub(super) fn maybe_states(self, name: &str, values: Option<&Vec<f64>>) -> Self {
        match values {
            Some(values) => self.states(name, values),
            None => self,
        }
    }

    /// Names for the values in these fields, which belong to the states.
    pub(super) fn by_state(mut self, names: &[&str]) -> Self {
        for name in names {
            if let Some(Value::Array(values)) = self.fields.get_mut(*name).map(Value::take) {
                self = self.states(name, values);
            }
        }
        self
    }

    /// The mode of each contact, if there are any.
    pub(super) fn modes(self, modes: &[Mode]) -> Self {
        let contacts = (0..modes.len()).map(|i| self.info.contact(i).unwrap_or("?"));
        let named = named(contacts, modes.iter().map(Mode::to_string));
        self.maybe("modes", (!modes.is_empty()).then_some(named))
    }

    /// Values of all parameters.
    pub(super) fn parameters(self, values: &[f64]) -> Self {
        let names = self.info.parameters.iter().map(|declared| declared.name);
        let named = named(names, values);
        self.put("parameters", named)
    }

    /// What is followed, from where to where.
    pub(super) fn range(self, name: &str, along: &Along) -> Self {
        let range = json!({ "name": along.name(self.info), "from": along.from, "to": along.to });
        self.put(name, range)
    }

    /// Why what was followed ended.
    pub(super) fn ended(self, ended: &Ended) -> Self {
        self.put("ended", ended.word()).put("reason", &ended.reason)
    }

    /// The units of states, parameters, friction forces and observables, and of time.
    pub(super) fn units(self) -> Self {
        let units = units(self.info);
        self.put("units", units)
    }
}

impl Serialize for Document<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.fields.serialize(serializer)
    }
}

impl From<Document<'_>> for Value {
    fn from(document: Document<'_>) -> Self {
        Self::Object(document.fields)
    }
}

/// Values by name, in the order of declaration.
pub(super) fn named<'a, T: Serialize>(
    names: impl Iterator<Item = &'a str>,
    values: impl IntoIterator<Item = T>,
) -> Value {
    let pairs = names.zip(values);
    Value::Object(
        pairs
            .map(|(name, value)| (name.to_owned(), value_of(value)))
            .collect(),
    )
}

/// Rows as columns, of which there are so many even where there are no rows.
pub(super) fn columns(rows: &[Vec<f64>], count: usize) -> impl Iterator<Item = Vec<f64>> {
    let column = |j: usize| rows.iter().filter_map(|row| row.get(j).copied()).collect();
    (0..count).map(column)
}

/// The version of the form of all documents: see the page of `--json-schema`.
pub(super) const SCHEMA: u64 = 1;

/// A document that says first in which form it is.
pub(super) fn versioned(document: Value) -> Value {
    let mut fields = Map::new();
    fields.insert("schema".to_owned(), SCHEMA.into());
    if let Value::Object(given) = document {
        fields.extend(given);
    }
    Value::Object(fields)
}

/// A logarithm, of which JSON has no number where it is that of nothing.
pub(super) fn logarithm(value: Option<f64>) -> Value {
    match value {
        Some(f64::NEG_INFINITY) => "-inf".into(),
        other => value_of(other),
    }
}

/// A value as JSON; nothing is written of what has no form there.
pub(super) fn value_of(value: impl Serialize) -> Value {
    serde_json::to_value(value).unwrap_or_default()
}

/// A unit as it is written.
pub(super) fn unit(unit: Option<Unit>) -> Option<&'static str> {
    unit.map(|unit| unit.text)
}

fn units(info: &ModelInfo) -> Value {
    let states = info.states.iter().map(|state| (state.name, state.unit));
    let parameters = info
        .parameters
        .iter()
        .map(|declared| (declared.name, declared.unit));
    let observables = info.observables.iter().map(|line| (line.name, line.unit));
    let named = states
        .chain(parameters)
        .chain(info.forces())
        .chain(observables);
    let mut units: Map<String, Value> = named
        .filter_map(|(name, of)| Some((name.to_owned(), value_of(unit(of)?))))
        .collect();
    let times = [
        ("time", "s"),
        ("period", "s"),
        ("frequency", "1/s"),
        ("eigenvalues", "1/s"),
    ];
    if !time_unit(info).is_empty() {
        for (name, unit) in times {
            units.entry(name).or_insert_with(|| value_of(unit));
        }
    }
    Value::Object(units)
}

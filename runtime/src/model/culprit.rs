//! Which formula of a model is not finite at a state.

use std::collections::HashMap;

use super::formula::{Part, evaluate};
use super::info::{Contact, Memory, ModelInfo, Press};
use super::values::brief;

/// What is known by name, as far as it is known.
type Known<'a> = HashMap<&'a str, f64>;

impl ModelInfo {
    /// The first formula that is not finite at a state, in words: its line, the part of it, and what that is made of.
    ///
    /// Formulas are read as they were written, which takes its time: for messages only. `None` if all are finite, as
    /// far as they do not need a friction force.
    #[must_use]
    pub(crate) fn culprit(&self, parameters: &[f64], state: &[f64]) -> Option<String> {
        let parameters = self.parameters.iter().map(|one| one.name).zip(parameters);
        let states = self.states.iter().map(|one| one.name).zip(state);
        let mut known: Known<'_> = parameters
            .chain(states)
            .map(|(name, v)| (name, *v))
            .collect();
        let found = self.look(&mut known, state).err();
        found.map(|(line, part)| told(&line, &part))
    }

    fn look(&self, known: &mut Known<'_>, state: &[f64]) -> Result<(), (String, Part)> {
        for quantity in self.observables {
            let line = || format!("let {}", quantity.name);
            if let Some(value) = value(quantity.formula, known, line)? {
                known.insert(quantity.name, value);
            }
        }
        for contact in self.contacts {
            of_contact(contact, known)?;
        }
        for press in self.presses {
            of_press(press, known)?;
        }
        for memory in self.memories {
            of_memory(memory, known, state)?;
        }
        for one in self.states {
            value(one.equation, known, || format!("der({})", one.name))?;
        }
        Ok(())
    }
}

fn told(line: &str, part: &Part) -> String {
    let arguments: Vec<String> = part.arguments.iter().map(|value| brief(*value)).collect();
    let (text, value) = (&part.text, part.value);
    format!(
        "`{text}` in `{line}` is {value} at {}",
        arguments.join(" and ")
    )
}

fn value(
    formula: &str,
    known: &Known<'_>,
    line: impl Fn() -> String,
) -> Result<Option<f64>, (String, Part)> {
    evaluate(formula, &|name| known.get(name).copied()).map_err(|part| (line(), part))
}

/// The fields of a law where it acts, and the speed under the name that the law has for it.
fn fields<'a>(
    (force, law, fields): (&str, &str, &'a str),
    known: &Known<'_>,
) -> Result<Known<'a>, (String, Part)> {
    let mut own = Known::new();
    for (name, formula) in separate(fields) {
        let line = || format!("{force} = {law} {{ {name}: .. }}");
        if let Some(value) = value(formula, known, line)? {
            own.insert(name, value);
        }
    }
    Ok(own)
}

fn of_contact(contact: &Contact, known: &Known<'_>) -> Result<(), (String, Part)> {
    let (force, law) = (contact.name, contact.law);
    let mut own = fields((force, law.name, contact.fields), known)?;
    let speed = value(contact.speed, known, || format!("{force} = .. opposing .."))?;
    value(law.stick, &own, || {
        format!("stick of {} at {force}", law.name)
    })?;
    if let Some(speed) = speed {
        own.insert("s", speed.abs());
    }
    value(law.slip, &own, || {
        format!("slip(s) of {} at {force}", law.name)
    })?;
    Ok(())
}

fn of_press(press: &Press, known: &Known<'_>) -> Result<(), (String, Part)> {
    let (force, law) = (press.name, press.law);
    let mut own = fields((force, law.name, press.fields), known)?;
    let Some(gap) = value(press.gap, known, || format!("{force} = .. closing .."))? else {
        return Ok(());
    };
    own.extend(law.at_rest(gap));
    let (line, formula) = law.line();
    let at = |line: &str| format!("{line} of {} at {force}", law.name);
    for (name, formula) in law.abbreviations {
        if let Some(value) = value(formula, &own, || at(&format!("let {name}")))? {
            own.insert(name, value);
        }
    }
    value(formula, &own, || at(&line)).map(drop)
}

fn of_memory(memory: &Memory, known: &Known<'_>, state: &[f64]) -> Result<(), (String, Part)> {
    let (force, law) = (memory.name, memory.law);
    let mut own = fields((force, law.name, memory.fields), known)?;
    if let Some(speed) = value(memory.speed, known, || format!("{force} = .. opposing .."))? {
        own.insert(law.speed, speed);
    }
    for (inner, place) in law.states.iter().zip(memory.states) {
        own.extend(state.get(*place).map(|value| (inner.name, *value)));
    }
    let at = |line: &str| format!("{line} of {} at {force}", law.name);
    for (name, formula) in law.abbreviations {
        if let Some(value) = value(formula, &own, || at(&format!("let {name}")))? {
            own.insert(name, value);
        }
    }
    for inner in law.states {
        value(inner.equation, &own, || at(&format!("der({})", inner.name)))?;
    }
    value(law.force, &own, || at(&format!("force({})", law.speed)))?;
    Ok(())
}

/// Names and formulas of `limit: F_s, decay: powi(delta, 2)`.
fn separate(fields: &str) -> Vec<(&str, &str)> {
    let (mut depth, mut from, mut pieces) = (0_i32, 0, Vec::new());
    for (at, letter) in fields.char_indices() {
        match letter {
            '(' => depth += 1,
            ')' => depth -= 1,
            ',' if depth == 0 => {
                pieces.push(&fields[from..at]);
                from = at + 1;
            }
            _ => {}
        }
    }
    pieces.push(&fields[from..]);
    let pairs = pieces.into_iter().filter_map(|piece| piece.split_once(':'));
    pairs
        .map(|(name, formula)| (name.trim(), formula.trim()))
        .collect()
}

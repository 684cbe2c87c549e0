//! A law as text.

use super::curve::Curve;
use super::exhibit::Drawn;
use crate::app::text::{indented, number, short, summary, table, unit};
use crate::friction::LawParameter;

/// Digits shown of a force.
const DIGITS: usize = 6;

/// A law in a list.
pub(super) fn list(drawn: &Drawn) -> String {
    let [stick, slip] = drawn.formulas();
    format!(
        "{}\n  {}\n    {stick}\n    {slip}\n    {}\n",
        drawn.name,
        summary(drawn.law.doc),
        values_of(drawn.law.parameters, &drawn.values)
    )
}

/// The values of a law's parameters in one line.
pub(super) fn values_of(parameters: &[LawParameter], values: &[f64]) -> String {
    let pairs = parameters.iter().zip(values);
    let pairs: Vec<String> = pairs
        .map(|(declared, &value)| assigned(declared, value))
        .collect();
    pairs.join(", ")
}

fn assigned(declared: &LawParameter, value: f64) -> String {
    format!(
        "{} = {}{}",
        declared.name,
        short(value),
        unit(declared.unit)
    )
}

/// The values of a law's parameters with bounds and meaning.
pub(super) fn settings(parameters: &[LawParameter], values: &[f64]) -> String {
    let rows = parameters.iter().zip(values).map(|(declared, &value)| {
        vec![
            assigned(declared, value),
            declared.bounds.describe(declared.name),
            summary(declared.doc),
        ]
    });
    table(&rows.collect::<Vec<_>>())
}

/// A law with all that is known of it.
pub(super) fn describe(drawn: &Drawn) -> String {
    let law = drawn.law;
    let mut text = format!("{}\n{}", drawn.name, indented(law.doc));
    let [stick, slip] = drawn.formulas();
    text += &format!("\nformulas\n  {stick}\n  {slip}\n");
    if let Some(place) = &drawn.place {
        text += &format!("\ncontact\n  {place}\n");
    }
    if !drawn.values.is_empty() {
        text += &format!("\nparameters\n{}", settings(law.parameters, &drawn.values));
    }
    text + "\nforce against speed\n" + &table(&rows(&drawn.curve))
}

fn rows(curve: &Curve) -> Vec<Vec<String>> {
    let mut rows = vec![curve.heads()];
    rows.push(vec![
        "at rest".to_owned(),
        format!("up to {}", number(curve.at_rest, DIGITS)),
    ]);
    rows.extend(curve.samples().map(|sample| {
        let numbers = [Some(sample.speed), sample.force, sample.copy];
        numbers
            .into_iter()
            .flatten()
            .map(|value| number(value, DIGITS))
            .collect()
    }));
    rows
}

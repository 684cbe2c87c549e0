//! Answers as text: numbers at sensible digits, in aligned columns, with their units.

use super::width::{GAP, WIDTH};
use crate::field::Work;
use crate::model::{ModelInfo, Unit};
use crate::study::{Along, Case, Dynamics};

/// A number with this many significant digits.
pub(super) fn number(value: f64, digits: usize) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return format!("{value}");
    }
    let scientific = format!("{value:.*e}", digits.max(1) - 1);
    let exponent: i32 = scientific
        .split_once('e')
        .and_then(|(_, exponent)| exponent.parse().ok())
        .unwrap_or(0);
    let decimals = digits as i32 - 1 - exponent;
    if exponent < -4 || decimals < 0 {
        return scientific;
    }
    format!("{value:.*}", decimals as usize)
}

/// A number that is known to the last of so many digits of a larger one, if to more than none.
pub(super) fn beside(value: f64, larger: f64, digits: usize) -> String {
    let place = |value: f64| value.abs().log10().floor();
    let left = digits as f64 - (place(larger) - place(value)).max(0.0);
    number(if left < 1.0 { 0.0 } else { value }, left as usize)
}

/// A number as a user would type it.
pub(super) fn short(value: f64) -> String {
    let (plain, scientific) = (format!("{value}"), format!("{value:e}"));
    if plain.len() <= scientific.len() + 2 {
        plain
    } else {
        scientific
    }
}

/// The digits that a result with this relative error deserves.
pub(super) fn digits(error: f64) -> usize {
    left(error, [4, 12])
}

/// The digits of the design variable at a special point: ten, or as many as its error leaves, down to one.
pub(super) fn certain(r: f64, error: Option<f64>) -> usize {
    const SHOWN: usize = 10;
    error.map_or(SHOWN, |error| left(error / r.abs(), [1, SHOWN]))
}

/// The design variable at a special point with the digits that it deserves; zero, if it is that as far as its error tells.
pub(super) fn located(r: f64, error: Option<f64>) -> String {
    let zero = error.is_some_and(|error| error >= r.abs());
    number(if zero { 0.0 } else { r }, certain(r, error))
}

/// The digits that this relative error leaves, within these bounds; four where it says nothing.
fn left(error: f64, [least, most]: [usize; 2]) -> usize {
    let digits = -error.log10();
    if digits.is_finite() {
        (digits.max(0.0) as usize).clamp(least, most)
    } else {
        4
    }
}

/// Words of which the first are shown, if they are many.
pub(super) fn brief(words: &str) -> String {
    const MOST: usize = 60;
    match words.char_indices().nth(MOST) {
        None => words.to_owned(),
        Some((end, _)) => {
            let shown = &words[..end];
            let whole = shown.rsplit_once(' ').map_or(shown, |(whole, _)| whole);
            let all = words.split(' ').count();
            format!("{whole} ... ({all} words)")
        }
    }
}

/// The first paragraph of a documentation, in one line.
pub(super) fn summary(doc: &str) -> String {
    let first = doc.trim().split("\n\n").next().unwrap_or_default();
    first.lines().map(str::trim).collect::<Vec<_>>().join(" ")
}

/// A name with its unit, as the head of a row.
pub(super) fn label(name: &str, unit: Option<Unit>) -> String {
    match unit {
        Some(unit) if unit.text != "1" => format!("{name} ({})", unit.text),
        _ => name.to_owned(),
    }
}

/// A unit after a space; nothing if there is none to be named.
pub(super) fn unit(unit: Option<Unit>) -> String {
    match unit {
        Some(unit) if unit.text != "1" => format!(" {}", unit.text),
        _ => String::new(),
    }
}

/// A documentation under its heading.
pub(super) fn indented(doc: &str) -> String {
    let lines = doc
        .trim()
        .lines()
        .map(|line| format!("  {line}").trim_end().to_owned() + "\n");
    lines.collect()
}

/// A word that names a time, or `power` of one, with its unit as the head of a column.
pub(super) fn timed(info: &ModelInfo, word: &str, power: &str) -> String {
    if time_unit(info).is_empty() {
        word.to_owned()
    } else {
        format!("{word} ({power})")
    }
}

/// What is followed with its unit, as the head of a column.
pub(super) fn followed(info: &ModelInfo, along: &Along) -> String {
    let declared = along.design.parameter();
    let declared = declared.and_then(|index| info.parameters.get(index));
    let unit = declared.and_then(|declared| declared.unit);
    label(along.name(info), unit)
}

/// The unit of time: seconds, if the model states units at all.
pub(super) fn time_unit(info: &ModelInfo) -> &'static str {
    let stated = info.states.iter().filter_map(|state| state.unit);
    if stated.into_iter().any(|unit| unit.dimension != [0; 7]) {
        " s"
    } else {
        ""
    }
}

/// From so many columns on, what is too wide for a line is divided into blocks.
const MANY: usize = 4;

/// Lines whose cells stand between tabs, each column as wide as its widest cell, indented; many columns that are too wide
/// for a line stand in blocks, each of which begins with the first column.
pub(super) fn table(lines: &str) -> String {
    let rows: Vec<Vec<&str>> = lines
        .lines()
        .map(|line| line.split('\t').collect())
        .collect();
    let mut widths: Vec<usize> = Vec::new();
    for row in &rows {
        for (j, cell) in row.iter().enumerate() {
            widths.resize(widths.len().max(j + 1), 0);
            widths[j] = widths[j].max(cell.chars().count());
        }
    }
    let aligned = |columns: &Vec<usize>| -> String {
        let line = |row: &Vec<&str>| {
            let cells = columns
                .iter()
                .filter_map(|&j| Some((row.get(j)?, widths[j])));
            let line: String = cells
                .map(|(cell, width)| format!("  {cell:<width$}"))
                .collect();
            line.trim_end().to_owned() + "\n"
        };
        rows.iter().map(line).collect()
    };
    let blocks: Vec<String> = blocks(&widths).iter().map(aligned).collect();
    blocks.join("\n")
}

/// The columns of each block: all in one where they fit, or are few.
fn blocks(widths: &[usize]) -> Vec<Vec<usize>> {
    let all: usize = widths.iter().map(|width| GAP + width).sum();
    if all <= WIDTH || widths.len() < MANY {
        return vec![(0..widths.len()).collect()];
    }
    let mut blocks = vec![vec![0]];
    let mut used = GAP + widths[0];
    for (j, width) in widths.iter().enumerate().skip(1) {
        let block = blocks.len() - 1;
        if used + GAP + width > WIDTH && blocks[block].len() > 1 {
            blocks.push(vec![0, j]);
            used = 2 * GAP + widths[0] + width;
        } else {
            blocks[block].push(j);
            used += GAP + width;
        }
    }
    blocks
}

/// A line of cells.
pub(super) fn line(cells: impl IntoIterator<Item = String>) -> String {
    cells.into_iter().collect::<Vec<_>>().join("\t") + "\n"
}

/// The heading of an answer: the model, what is shown of it, and its parameters.
pub(super) fn heading(info: &ModelInfo, case: &Case, what: &str) -> String {
    let (model, how) = (info.command, friction(info, case));
    format!("{model}, {how}: {what}\n  {}\n\n", parameters(info, case))
}

/// How friction acts, in words: a law with internal state is friction too, though nothing is solved for or smoothed.
fn friction(info: &ModelInfo, case: &Case) -> String {
    match case.dynamics {
        Dynamics::Smooth if !info.memories.is_empty() => "friction with memory".to_owned(),
        dynamics => dynamics.to_string(),
    }
}

/// The states with their units, as the heads of columns, each after `prefix`.
pub(super) fn states(info: &ModelInfo, prefix: &str) -> impl Iterator<Item = String> {
    let states = info.states.iter();
    states.map(move |state| label(&format!("{prefix}{}", state.name), state.unit))
}

/// A value with its name and unit.
pub(super) fn assigned(name: &str, value: f64, of: Option<Unit>) -> String {
    format!("{name} = {}{}", short(value), unit(of))
}

/// The parameters of a case, in one line; nothing is said of modes that are kept as they are.
pub(super) fn parameters(info: &ModelInfo, case: &Case) -> String {
    let modes = info.structures.iter().flat_map(|one| one.modes);
    let shares: Vec<usize> = modes.filter_map(|mode| mode.share).collect();
    let pairs = info.parameters.iter().zip(&case.parameters).enumerate();
    let told = pairs.filter(|(index, (_, value))| **value != 1.0 || !shares.contains(index));
    let pairs = told.map(|(_, (declared, &value))| assigned(declared.name, value, declared.unit));
    pairs.collect::<Vec<_>>().join(", ")
}

/// Counted work in one line.
pub(super) fn work(work: &Work) -> String {
    let told = work.counts().filter(|(count, _)| *count > 0);
    told.map(|(count, name)| format!("{count} {name}"))
        .collect::<Vec<_>>()
        .join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn significant_digits_are_kept() {
        assert_eq!(number(12.345_678, 4), "12.35");
        assert_eq!(number(-0.001_234_5, 3), "-0.00123");
        assert_eq!(number(9.999_96, 4), "10.00");
        assert_eq!(number(1.5e-7, 3), "1.50e-7");
        assert_eq!(number(123_456.0, 3), "1.23e5");
        assert_eq!(number(0.0, 3), "0");
        let below = |value| beside(value, -21.5, 6);
        assert_eq!(below(-0.001_234), "-0.0012");
        assert_eq!(below(33.333_333), "33.3333");
        assert_eq!([below(9e-6), below(0.0)], ["0", "0"]);
    }

    #[test]
    fn a_special_point_has_the_digits_that_its_error_leaves() {
        let errors = [3.4, 1e-3, 3e-8, 1e-15];
        let left = errors.map(|error| certain(-11.28, Some(error)));
        assert_eq!(left, [1, 4, 8, 10]);
        assert_eq!(certain(-11.28, None), 10);
        let at = |r, error| located(r, Some(error));
        assert_eq!([at(1e-15, 1e-10), at(-2.5e-3, 3e-6)], ["0", "-0.0025"]);
    }

    #[test]
    fn columns_are_aligned() {
        assert_eq!(table("a\tbb\nccc\td\n"), "  a    bb\n  ccc  d\n");
    }
}

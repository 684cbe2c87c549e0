//! Tables as data: what is typeset as a number is one, of one unit in each column.

use super::symbols::spelt;
use super::{Table, text};

/// What a cell of a column of numbers says.
enum Cell {
    /// A number, and its unit if the cell names it.
    Number(String, &'static str),
    Nothing,
    Words(String),
}

/// Units in which durations are printed, and what they are in seconds, as an exponent of ten.
const TIMES: [(&str, i32); 3] = [(" s", 0), (" ms", -3), (" µs", -6)];

/// The head and the rows of a table, no two heads the same; words among numbers stand in a column of their own.
pub(super) fn rows(table: &Table) -> Vec<Vec<String>> {
    let mut columns: Vec<Vec<String>> = Vec::new();
    let mut before = String::new();
    for (j, column) in table.columns.iter().enumerate() {
        let head = distinct(text::plain(&column.head), &before, &columns);
        before.clone_from(&head);
        let cells = table.rows.iter().map(|row| row[j].as_str());
        if column.numeric {
            columns.extend(numbers(head, cells.map(read).collect()));
        } else {
            columns.push(
                std::iter::once(head)
                    .chain(cells.map(text::plain))
                    .collect(),
            );
        }
    }
    let row = |i: usize| columns.iter().map(|column| column[i].clone()).collect();
    let rows = (0..=table.rows.len()).map(row);
    rows.map(|row: Vec<String>| row.iter().map(|cell| ascii(cell)).collect())
        .collect()
}

/// A text in the letters that every program reads, whatever it takes the file to be written in.
pub(super) fn ascii(text: &str) -> String {
    let letter = |letter: char| match letter {
        '−' | '–' => "-".to_owned(),
        '×' => "x".to_owned(),
        'µ' => "u".to_owned(),
        '′' => "'".to_owned(),
        '″' => "''".to_owned(),
        '≤' => "<=".to_owned(),
        '≥' => ">=".to_owned(),
        '≈' => "~".to_owned(),
        '→' => "->".to_owned(),
        '\u{a0}' | '\u{202f}' => " ".to_owned(),
        '₀'..='₉' => (letter as u32 - '₀' as u32).to_string(),
        other if other.is_ascii() => other.to_string(),
        other => spelt(other).unwrap_or_else(|| "?".to_owned()),
    };
    text.chars().map(letter).collect()
}

/// A head that no column has yet: if need be with what the one before is of, `a, thesis` before `here`.
fn distinct(head: String, before: &str, columns: &[Vec<String>]) -> String {
    let taken = |head: &str| columns.iter().any(|column| column[0] == head);
    let (of, beside) = before.rsplit_once(", ").unwrap_or((before, ""));
    if !taken(&head) && (beside.is_empty() || head != "here") {
        return head;
    }
    let named = format!("{of}, {head}");
    let mut all = std::iter::once(named.clone()).chain((2..).map(|n| format!("{named} {n}")));
    all.find(|name| !taken(name)).unwrap_or(named)
}

/// A column of numbers, and one of the words among them if there are any.
fn numbers(head: String, cells: Vec<Cell>) -> Vec<Vec<String>> {
    let timed = cells
        .iter()
        .any(|cell| matches!(cell, Cell::Number(_, "s")));
    let spoken = cells.iter().any(|cell| matches!(cell, Cell::Words(_)));
    let unit = if timed { " (s)" } else { "" };
    let counted = cells.iter().any(|cell| matches!(cell, Cell::Number(..)));
    let beside = if counted { ", words" } else { "" };
    let (mut values, mut words) = (
        vec![format!("{head}{unit}")],
        vec![format!("{head}{beside}")],
    );
    for cell in cells {
        let (value, word) = match cell {
            Cell::Number(value, _) => (value, String::new()),
            Cell::Nothing => Default::default(),
            Cell::Words(word) => (String::new(), word),
        };
        values.push(value);
        words.push(word);
    }
    let values = (counted || !spoken).then_some(values);
    values.into_iter().chain(spoken.then_some(words)).collect()
}

/// What a cell says: `−8.597 × 10^{−4}`, `1 234` with thin spaces, `18 µs`, `–`.
fn read(cell: &str) -> Cell {
    if matches!(cell.trim(), "" | "–" | "-") {
        return Cell::Nothing;
    }
    for (unit, power) in TIMES {
        if let Some(value) = cell.strip_suffix(unit).and_then(number) {
            return Cell::Number(scaled(&value, power), "s");
        }
    }
    number(cell).map_or_else(
        || Cell::Words(text::plain(cell)),
        |value| Cell::Number(value, ""),
    )
}

/// The digits of a typeset number, in plain letters.
fn number(cell: &str) -> Option<String> {
    let plain = cell.replace('−', "-").replace('\u{202f}', "");
    let (digits, power) = match plain
        .strip_suffix('}')
        .and_then(|cell| cell.rsplit_once("10^{"))
    {
        Some(("", power)) => ("1".to_owned(), power),
        Some((digits, power)) => (digits.strip_suffix(" × ")?.to_owned(), power),
        None => (plain.clone(), ""),
    };
    let exponent = if power.is_empty() { "" } else { "e" };
    let text = format!("{digits}{exponent}{power}");
    text.parse::<f64>().is_ok().then_some(text)
}

fn scaled(digits: &str, power: i32) -> String {
    if power == 0 {
        digits.to_owned()
    } else {
        format!("{digits}e{power}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::Column;

    #[test]
    fn numbers_are_numbers_and_words_stand_beside_them() {
        let column = |head: &str, numeric| Column {
            head: head.to_owned(),
            numeric,
        };
        let row = |cells: [&str; 4]| cells.map(str::to_owned).to_vec();
        let table = Table {
            name: String::new(),
            caption: String::new(),
            columns: vec![
                column("*a*, thesis", true),
                column("here", true),
                column("time", true),
                column("of *x*", false),
            ],
            folded: false,
            rows: vec![
                row(["−0.58", "8.597 × 10^{−4}", "1.5 s", "stable"]),
                row(["10^{5}", "1\u{202f}234", "18 µs", "−1"]),
                row(["–", "all 3 orbits stable", "", ""]),
            ],
        };
        let expected = [
            ["a, thesis", "a, here", "a, here, words", "time (s)", "of x"],
            ["-0.58", "8.597e-4", "", "1.5", "stable"],
            ["1e5", "1234", "", "18e-6", "-1"],
            ["", "", "all 3 orbits stable", "", ""],
        ];
        assert_eq!(rows(&table), expected);
    }

    #[test]
    fn a_column_without_numbers_is_one_of_words() {
        let cells = ["about 20", "–"].map(read).into_iter().collect();
        assert_eq!(
            numbers("thesis".to_owned(), cells),
            [["thesis", "about 20", ""]]
        );
    }

    #[test]
    fn every_letter_has_plain_ones() {
        assert_eq!(
            ascii("−0.5 × ζθ → T″, x₁ ≤ 3 µs"),
            "-0.5 x zetatheta -> T'', x1 <= 3 us"
        );
        assert_eq!(ascii("Ω, ς, ω, é"), "Omega, sigma, omega, ?");
    }
}

//! Nastran's `DMIG` entries in punch and bulk data files: Quick Reference Guide, DMIG.

use std::collections::HashMap;

use super::lines::{Line, Lines};
use crate::reduce::coefficients::{Coefficients, Source};
use crate::reduce::error::ReduceError;
use crate::reduce::place::Place;

/// Whether a line of the text is such an entry.
pub(super) fn is(text: &str) -> bool {
    text.lines()
        .any(|line| line.to_ascii_uppercase().starts_with("DMIG"))
}

/// An entry with its continuations: the fields after the keyword.
struct Entry<'a> {
    line: Line<'a>,
    fields: Vec<&'a str>,
}

/// Reads the one matrix of the file, or the one whose name begins as that of a stiffness, a mass or a damping does.
pub(super) fn read(lines: &Lines<'_>, role: &str) -> Result<Coefficients, ReduceError> {
    let all = entries(lines)?;
    let headings = all.iter().filter(|entry| entry.is_heading());
    let headings: Vec<&Entry<'_>> = headings.collect();
    let heading = match headings[..] {
        [] => {
            return Err(
                lines.lacks("no `DMIG` line says the form of the matrix: its second field is 0")
            );
        }
        [one] => one,
        _ => chosen(&headings, role, lines)?,
    };
    let whole = heading.is_whole()?;
    let mut gathered = Gathered::default();
    let of_it = |entry: &&Entry<'_>| !entry.is_heading() && entry.name() == heading.name();
    for entry in all.iter().filter(of_it) {
        gathered.column(entry)?;
    }
    Ok(Coefficients {
        source: Source::default(),
        unknowns: gathered.places.len(),
        places: gathered.places,
        scattered: true,
        whole,
        entries: gathered.entries,
    })
}

fn chosen<'a, 'b>(
    headings: &[&'a Entry<'b>],
    role: &str,
    lines: &Lines<'_>,
) -> Result<&'a Entry<'b>, ReduceError> {
    let letters = match role {
        "stiffness" => "K",
        "mass" => "M",
        _ => "BCD",
    };
    let fits = |entry: &&&Entry<'_>| entry.name().starts_with(|first| letters.contains(first));
    let fitting: Vec<_> = headings.iter().filter(fits).collect();
    match fitting[..] {
        [one] => Ok(one),
        _ => {
            let names: Vec<String> = headings.iter().map(|entry| entry.name()).collect();
            Err(lines.lacks(format!(
                "it holds the matrices {}: which is the {role} is not clear, since {} of these names begin with {letters}; \
                 put it into a file of its own",
                names.join(", "),
                fitting.len()
            )))
        }
    }
}

/// The places and the entries of a matrix.
#[derive(Default)]
struct Gathered {
    places: Vec<Place>,
    known: HashMap<Place, u32>,
    entries: Vec<(u32, u32, f64)>,
}

impl Gathered {
    fn column(&mut self, entry: &Entry<'_>) -> Result<(), ReduceError> {
        let place = entry.place(1)?;
        let column = self.number(place);
        let rows = entry.fields.get(4..).unwrap_or_default();
        for at in (0..rows.len()).step_by(4) {
            if rows[at].is_empty() {
                continue;
            }
            let row = self.number(entry.place(4 + at)?);
            let value = entry
                .line
                .value(rows.get(at + 2).copied().unwrap_or_default())?;
            if rows
                .get(at + 3)
                .is_some_and(|imaginary| !imaginary.is_empty())
            {
                return Err(entry
                    .line
                    .wrong("complex matrices are not read: give structural damping by a ratio"));
            }
            self.entries.push((row, column, value));
        }
        Ok(())
    }

    fn number(&mut self, place: Place) -> u32 {
        let next = self.places.len() as u32;
        *self.known.entry(place).or_insert_with(|| {
            self.places.push(place);
            next
        })
    }
}

impl Entry<'_> {
    fn name(&self) -> String {
        self.fields
            .first()
            .copied()
            .unwrap_or_default()
            .to_ascii_uppercase()
    }

    fn is_heading(&self) -> bool {
        self.fields.get(1) == Some(&"0")
    }

    /// Whether both triangles are there.
    fn is_whole(&self) -> Result<bool, ReduceError> {
        match self.fields.get(2).copied().unwrap_or_default() {
            "6" => Ok(false),
            "1" => Ok(true),
            other => Err(self.line.wrong(format!(
                "a matrix of form `{other}` is neither stiffness nor mass: 6, symmetric, and 1, square, are read"
            ))),
        }
    }

    /// The place in two fields.
    fn place(&self, at: usize) -> Result<Place, ReduceError> {
        let field = |at: usize| self.fields.get(at).copied().unwrap_or_default();
        let (node, direction) = (field(at), field(at + 1));
        let node = u64::from(self.line.index(node)?);
        let direction = if direction.is_empty() { "0" } else { direction };
        let parsed = direction.parse().ok().filter(|one| (0..=6).contains(one));
        let direction = parsed.ok_or_else(|| {
            self.line
                .wrong(format!("`{direction}` is no component: there are 0 to 6"))
        })?;
        Ok(Place { node, direction })
    }
}

/// The `DMIG` entries; comments and all else are passed over.
fn entries<'a>(lines: &Lines<'a>) -> Result<Vec<Entry<'a>>, ReduceError> {
    let mut all: Vec<Entry<'a>> = Vec::new();
    let mut open = false;
    for line in lines.all() {
        let begins = line.text.to_ascii_uppercase().starts_with("DMIG");
        let continues = line.text.starts_with(['*', '+', ' ', ',']);
        if begins {
            all.push(Entry {
                line,
                fields: Vec::new(),
            });
        } else if !(open && continues) {
            open = open && line.text.starts_with('$');
            continue;
        }
        open = true;
        if let Some(entry) = all.last_mut() {
            entry.line = line;
            entry.fields.extend(fields(&line)?);
        }
    }
    Ok(all)
}

/// The fields of a line between its first and its last: eight of 8 letters, four of 16, or what commas separate.
fn fields<'a>(line: &Line<'a>) -> Result<Vec<&'a str>, ReduceError> {
    let text = line.text;
    if !text.is_ascii() {
        return Err(line.wrong("an entry has only ASCII letters"));
    }
    let large = text
        .get(..8.min(text.len()))
        .is_some_and(|first| first.contains('*'));
    let (width, count) = if large { (16, 4) } else { (8, 8) };
    if text.contains(',') {
        let mut words: Vec<&str> = text.split(',').skip(1).take(count).map(str::trim).collect();
        words.resize(count, "");
        return Ok(words);
    }
    let from = |index: usize| (8 + width * index).min(text.len());
    Ok((0..count)
        .map(|index| text[from(index)..from(index + 1)].trim())
        .collect())
}

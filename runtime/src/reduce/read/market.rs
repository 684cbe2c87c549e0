//! Matrix Market: <https://math.nist.gov/MatrixMarket/formats.html>.

use super::lines::{Line, Lines};
use crate::reduce::coefficients::{Coefficients, Source};
use crate::reduce::error::ReduceError;

/// Reads a real matrix in coordinates, symmetric or general.
pub(super) fn read(lines: &Lines<'_>) -> Result<Coefficients, ReduceError> {
    let mut all = lines.all();
    let Some(heading) = all.next() else {
        return Err(lines.lacks("the heading is missing"));
    };
    let whole = is_whole(&heading)?;
    let mut rest = all.filter(|line| !line.text.trim_start().starts_with('%'));
    let Some(sizes) = rest.next() else {
        return Err(lines.lacks("the line with rows, columns and entries is missing"));
    };
    let (unknowns, count) = sized(&sizes)?;
    let mut entries = Vec::new();
    for line in rest {
        let words: Vec<&str> = line.text.split_whitespace().collect();
        let [row, column, value] = words[..] else {
            return Err(line.wrong("an entry is a row, a column and a value"));
        };
        let (row, column) = (line.row(row, unknowns)?, line.row(column, unknowns)?);
        entries.push((row, column, line.value(value)?));
    }
    if entries.len() != count {
        return Err(lines.lacks(format!(
            "{count} entries are announced, but there are {}",
            entries.len()
        )));
    }
    Ok(Coefficients {
        source: Source::default(),
        unknowns,
        places: Vec::new(),
        scattered: false,
        whole,
        entries,
    })
}

/// Whether both triangles are there.
fn is_whole(heading: &Line<'_>) -> Result<bool, ReduceError> {
    let words = heading.text.to_ascii_lowercase();
    let words: Vec<&str> = words.split_whitespace().collect();
    match words[..] {
        [_, "matrix", "coordinate", "real" | "integer" | "double", kind] => match kind {
            "symmetric" => Ok(false),
            "general" => Ok(true),
            other => Err(heading.wrong(format!(
                "a matrix that is `{other}` is neither stiffness nor mass: `symmetric` and `general` are read"
            ))),
        },
        _ => Err(heading.wrong(
            "write a sparse real matrix: `%%MatrixMarket matrix coordinate real symmetric`, or `general`",
        )),
    }
}

/// Rows and entries.
fn sized(line: &Line<'_>) -> Result<(usize, usize), ReduceError> {
    let words: Vec<&str> = line.text.split_whitespace().collect();
    let [rows, columns, count] = words[..] else {
        return Err(line.wrong("expected the numbers of rows, columns and entries"));
    };
    let (rows, columns) = (line.index(rows)?, line.index(columns)?);
    if rows != columns {
        return Err(line.wrong(format!(
            "the matrix has {rows} rows and {columns} columns: it must be square"
        )));
    }
    Ok((rows as usize, line.index(count)? as usize))
}

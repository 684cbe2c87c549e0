//! CalculiX: `.sti`, `.mas` and `.dof`, as `*FREQUENCY, SOLVER=MATRIXSTORAGE` writes them.

use super::lines::Lines;
use crate::reduce::coefficients::{Coefficients, Source};
use crate::reduce::error::ReduceError;
use crate::reduce::place::Place;

/// Reads rows, columns and values of one triangle.
pub(super) fn read(lines: &Lines<'_>) -> Result<Coefficients, ReduceError> {
    let mut entries = Vec::new();
    let mut unknowns = 0;
    for line in lines.all() {
        let words: Vec<&str> = line.text.split_whitespace().collect();
        let [row, column, value] = words[..] else {
            return Err(line.wrong("expected three columns: row, column and value"));
        };
        let most = u32::MAX as usize;
        let (row, column) = (line.row(row, most)?, line.row(column, most)?);
        unknowns = unknowns.max(row.max(column) as usize + 1);
        entries.push((row, column, line.value(value)?));
    }
    Ok(Coefficients {
        source: Source::default(),
        unknowns,
        places: Vec::new(),
        scattered: false,
        whole: false,
        entries,
    })
}

/// Reads the place of each row: `871.2` is node 871 along y.
pub(super) fn places(lines: &Lines<'_>) -> Result<Vec<Place>, ReduceError> {
    let mut places = Vec::new();
    for line in lines.all() {
        let word = line.text.trim();
        let parts = word.split_once('.');
        let place = parts.and_then(|(node, direction)| {
            let direction = direction.parse().ok().filter(|one| (1..=6).contains(one))?;
            Some(Place {
                node: node.parse().ok()?,
                direction,
            })
        });
        let place = place.ok_or_else(|| {
            line.wrong(format!(
                "`{word}` is no place: expected a node and a direction, as in `871.2`"
            ))
        })?;
        places.push(place);
    }
    Ok(places)
}

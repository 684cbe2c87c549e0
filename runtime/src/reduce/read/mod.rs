//! Matrices as other programs write them.

mod calculix;
mod dmig;
mod lines;
mod market;

use std::path::Path;

use super::coefficients::{Coefficients, Source};
use super::error::ReduceError;
use super::place::Place;
use lines::Lines;

/// Reads a matrix; `role` is `stiffness`, `mass` or `damping`, and says which of several matrices in a punch file is meant.
///
/// # Errors
/// The file cannot be read, is in none of the formats, or makes no sense at some line.
pub fn read(path: &Path, role: &str) -> Result<Coefficients, ReduceError> {
    let (file, text) = text_of(path)?;
    let source = Source {
        size: text.len(),
        checksum: crc32fast::hash(text.as_bytes()),
        file: file.clone(),
    };
    let lines = Lines::of(&file, &text);
    let mut read = match first_word(&text) {
        Some(word) if word.to_ascii_lowercase().starts_with("%%matrixmarket") => {
            market::read(&lines)?
        }
        _ if dmig::is(&text) => dmig::read(&lines, role)?,
        Some(word) if word.parse::<u64>().is_ok() => {
            let mut read = calculix::read(&lines)?;
            let beside = path.with_extension("dof");
            if beside.is_file() {
                place_rows(&mut read, &beside)?;
            }
            read
        }
        None => calculix::read(&lines)?,
        Some(_) => return Err(ReduceError::Unknown { file }),
    };
    read.source = source;
    Ok(read)
}

/// Gives the rows of a matrix the places that a file names, in their order: a line `node.direction` for each, as CalculiX
/// writes them.
///
/// # Errors
/// The file cannot be read, or names more or fewer rows than there are.
pub fn place_rows(matrix: &mut Coefficients, path: &Path) -> Result<(), ReduceError> {
    let places = places_of(path)?;
    if places.len() != matrix.unknowns {
        return Err(ReduceError::Malformed {
            file: path.display().to_string(),
            line: places.len(),
            reason: format!(
                "it names {} rows, but the matrix has {}",
                places.len(),
                matrix.unknowns
            ),
        });
    }
    matrix.places = places;
    Ok(())
}

/// Which place each row has, as CalculiX writes it: a line `node.direction` for each.
fn places_of(path: &Path) -> Result<Vec<Place>, ReduceError> {
    let (file, text) = text_of(path)?;
    calculix::places(&Lines::of(&file, &text))
}

fn text_of(path: &Path) -> Result<(String, String), ReduceError> {
    let file = path.file_name().unwrap_or(path.as_os_str());
    let file = file.to_string_lossy().into_owned();
    let unreadable = |reason: String| ReduceError::Unreadable {
        file: path.display().to_string(),
        reason,
    };
    let bytes = std::fs::read(path).map_err(|error| unreadable(error.to_string()))?;
    let text = String::from_utf8(bytes)
        .map_err(|_| unreadable("it is not text: write the matrix in a text format".to_owned()))?;
    Ok((file, text))
}

fn first_word(text: &str) -> Option<&str> {
    text.split_whitespace().next()
}

//! Which special point of a branch is followed.

use crate::continuation::Kind;
use crate::study::error::StudyError;

/// The number of the special point that is asked for, among kinds of these names that are `known`.
pub(super) fn choose(
    all: &[(String, Kind)],
    wanted: Option<&str>,
    (names, known): (&'static str, impl Fn(Kind) -> bool),
) -> Result<usize, StudyError> {
    let found = all.iter().position(|(label, kind)| match wanted {
        Some(wanted) => label == wanted,
        None => known(*kind),
    });
    let place = found.ok_or_else(|| StudyError::NoSpecial {
        wanted: wanted.map(str::to_owned),
        known: names,
        labels: all.iter().map(|(label, _)| label.clone()).collect(),
    })?;
    let (label, kind) = &all[place];
    if known(*kind) {
        Ok(place)
    } else {
        Err(not_followed(label, *kind))
    }
}

pub(super) fn not_followed(label: &str, kind: Kind) -> StudyError {
    StudyError::NotFollowed {
        label: label.to_owned(),
        kind: kind.name(),
    }
}

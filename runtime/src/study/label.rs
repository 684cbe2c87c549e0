//! The labels of special points.

use std::collections::HashMap;

use crate::continuation::Kind;

/// The label of each special point: its kind and number, for instance `PD1`.
pub(in crate::study) fn labels(
    kinds: impl IntoIterator<Item = Kind>,
) -> impl Iterator<Item = String> {
    let mut counts: HashMap<Kind, usize> = HashMap::new();
    kinds.into_iter().map(move |kind| {
        let count = counts.entry(kind).or_default();
        *count += 1;
        format!("{}{count}", kind.letters())
    })
}

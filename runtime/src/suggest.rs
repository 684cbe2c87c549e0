//! The nearest right name for a misspelt one.

/// The name nearest to `word`, if one is near enough that the user is likely to have meant it.
///
/// A third of its letters may be wrong, and one in any case, but not all of them.
///
/// ```
/// use stickslip::suggest::did_you_mean;
/// assert_eq!(did_you_mean("v_rd", ["v_dr", "delta"]), Some("v_dr"));
/// assert_eq!(did_you_mean("torque", ["v_dr", "delta"]), None);
/// ```
#[must_use]
pub fn did_you_mean<'a>(word: &str, names: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let key = |text: &str| text.to_lowercase().replace('_', "-");
    let edits = |name: &str| {
        let longest = word.chars().count().max(name.chars().count());
        let edits = strsim::osa_distance(&key(word), &key(name));
        (3 * edits <= longest.max(3) && edits < longest).then_some(edits)
    };
    let near = names.into_iter().filter(|name| *name != word);
    near.filter_map(|name| Some((edits(name)?, name)))
        .min()
        .map(|(_, name)| name)
}

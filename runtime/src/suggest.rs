//! The nearest right name for a misspelt one.

/// Letters of a beginning that are enough to guess a name.
const BEGUN: usize = 3;

/// The name nearest to `word`, if one is near enough that the user is likely to have meant it.
///
/// A third of its letters may be wrong, and one in any case, but not all of them; or it is how the name begins.
///
/// ```
/// use stickslip::suggest::did_you_mean;
/// assert_eq!(did_you_mean("v_rd", ["v_dr", "delta"]), Some("v_dr"));
/// assert_eq!(did_you_mean("belt-osc", ["belt-pair", "belt-oscillator"]), Some("belt-oscillator"));
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
    let names: Vec<&str> = names.into_iter().filter(|name| *name != word).collect();
    let near = names.iter().filter_map(|name| Some((edits(name)?, *name)));
    let begun = |name: &&&str| word.len() >= BEGUN && key(name).starts_with(&key(word));
    let begun = || names.iter().filter(begun).min_by_key(|name| name.len());
    near.min()
        .map(|(_, name)| name)
        .or_else(|| begun().copied())
}

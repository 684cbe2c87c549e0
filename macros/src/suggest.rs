//! Did you mean: the nearest known word.

/// The known word that `written` most likely stands for, if one is near enough.
///
/// A third of its letters may be wrong, and one in any case, but not all of them: physics has many names of one letter.
/// It is the rule of `stickslip::suggest`.
pub(crate) fn nearest<'a>(
    written: &str,
    known: impl IntoIterator<Item = &'a str>,
) -> Option<&'a str> {
    let key = |text: &str| text.to_lowercase().replace('_', "-");
    let edits = |name: &str| {
        let longest = written.chars().count().max(name.chars().count());
        let edits = strsim::osa_distance(&key(written), &key(name));
        (3 * edits <= longest.max(3) && edits < longest).then_some(edits)
    };
    let near = known.into_iter().filter(|name| *name != written);
    near.filter_map(|name| Some((edits(name)?, name)))
        .min()
        .map(|(_, name)| name)
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn near_words_are_proposed_and_far_ones_are_not() {
        let known = ["mass", "v", "F_s", "stiffness", "x"];
        let proposed = |written| nearest(written, known);
        assert_eq!(proposed("mas"), Some("mass"));
        assert_eq!(proposed("msas"), Some("mass"));
        assert_eq!(proposed("stifness"), Some("stiffness"));
        assert_eq!(proposed("f_s"), Some("F_s"));
        assert_eq!(proposed("vv"), Some("v"));
        assert_eq!(proposed("V"), Some("v"));
        assert_eq!(proposed("t"), None);
        assert_eq!(proposed("kk"), None);
    }
}

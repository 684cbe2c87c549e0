//! Did you mean: the nearest known word.

use std::collections::HashSet;

/// The known word that `written` most likely stands for, if one is near enough.
///
/// Physics has many names of one letter; those are near to nothing but their other case.
pub(crate) fn nearest<'a>(
    written: &str,
    known: impl IntoIterator<Item = &'a str>,
) -> Option<&'a str> {
    known
        .into_iter()
        .filter(|candidate| *candidate != written)
        .filter_map(|candidate| Some((closeness(written, candidate)?, candidate)))
        .min()
        .map(|(_, candidate)| candidate)
}

fn closeness(written: &str, candidate: &str) -> Option<usize> {
    if written.to_lowercase() == candidate.to_lowercase() {
        return Some(0);
    }
    let distance = edit_distance(written, candidate);
    let longest = written.chars().count().max(candidate.chars().count());
    let near = 3 * distance <= longest || is_doubled(written, candidate);
    near.then_some(distance)
}

/// `vv` for `v`: a letter struck twice.
fn is_doubled(written: &str, candidate: &str) -> bool {
    let letters: HashSet<char> = written.chars().collect();
    written.chars().count() == 2 && letters.len() == 1 && written.starts_with(candidate)
}

/// Insertions, deletions, replacements and swaps of neighbours that lead from one word to the other.
fn edit_distance(from: &str, to: &str) -> usize {
    let (from, to): (Vec<char>, Vec<char>) = (from.chars().collect(), to.chars().collect());
    let mut rows: Vec<Vec<usize>> = vec![(0..=to.len()).collect()];
    for i in 1..=from.len() {
        let mut row = vec![i];
        for j in 1..=to.len() {
            let replaced = rows[i - 1][j - 1] + usize::from(from[i - 1] != to[j - 1]);
            let mut best = replaced.min(rows[i - 1][j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1] {
                best = best.min(rows[i - 2][j - 2] + 1);
            }
            row.push(best);
        }
        rows.push(row);
    }
    rows[from.len()][to.len()]
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

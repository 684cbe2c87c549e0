//! What fits into a line of a terminal.

/// Letters in a line of a terminal.
pub(super) const WIDTH: usize = 80;

/// Between columns.
pub(super) const GAP: usize = 2;
/// Words in lines of at most eighty letters, each after `indent`.
pub(super) fn wrapped(text: &str, indent: &str) -> String {
    let mut lines = vec![indent.to_owned()];
    for word in text.split_whitespace() {
        let line = &lines[lines.len() - 1];
        let begun = line.len() > indent.len();
        if begun && line.chars().count() + 1 + word.chars().count() > WIDTH {
            lines.push(indent.to_owned());
        }
        let line = lines.last_mut().filter(|line| line.len() > indent.len());
        match line {
            Some(line) => *line += &format!(" {word}"),
            None => {
                let last = lines.len() - 1;
                lines[last] += word;
            }
        }
    }
    lines.iter().map(|line| format!("{line}\n")).collect()
}

/// The same text, with what is too wide for a line continued on the next ones, further to the right.
pub(super) fn fitted(text: &str) -> String {
    let fit = |line: &str| match line.chars().count() {
        0..=WIDTH => format!("{line}\n"),
        _ => continued(line, hanging(line)),
    };
    text.lines().map(fit).collect()
}

/// Where a line that is too wide goes on: under its last cell, or a bit to the right of its beginning.
fn hanging(line: &str) -> usize {
    let indent = line.len() - line.trim_start().len();
    let cell = line
        .trim_end()
        .rfind("  ")
        .map(|at| line[..at].chars().count() + GAP);
    let cell = cell.filter(|cell| (indent + 1..=WIDTH / 2).contains(cell));
    cell.unwrap_or(indent + 2 * GAP)
}

/// A line broken between words.
fn continued(line: &str, indent: usize) -> String {
    let (mut out, mut used) = (String::new(), 0);
    let mut rest = line;
    while !rest.is_empty() {
        let gap = rest.len() - rest.trim_start().len();
        let end = rest[gap..].find(' ').map_or(rest.len(), |end| gap + end);
        let (word, after) = rest.split_at(end);
        let length = word.chars().count();
        if used > indent && used + length > WIDTH {
            out += &format!("\n{:indent$}", "");
            out += word.trim_start();
            used = indent + word.trim_start().chars().count();
        } else {
            out += word;
            used += length;
        }
        rest = after;
    }
    out + "\n"
}

#[cfg(test)]
mod tests {
    use super::super::text::{line, table};
    use super::*;

    #[test]
    fn no_line_is_wider_than_a_terminal() {
        let words = "many words ".repeat(30);
        for text in [
            fitted(&words),
            wrapped(&words, "  "),
            fitted(&format!("    {words}")),
        ] {
            assert!(
                text.lines().all(|line| line.chars().count() <= WIDTH),
                "{text}"
            );
            assert_eq!(text.split_whitespace().count(), 60);
        }
        let wide: Vec<String> = (0..9).map(|j| format!("column number {j}")).collect();
        let blocks = table(&line(wide));
        assert!(blocks.lines().all(|line| line.chars().count() <= WIDTH));
        assert_eq!(blocks.matches("number 0").count(), 3);
        assert_eq!(blocks.matches("number 8").count(), 1);
    }
}

//! What a drawing is made of.

use crate::report::text::{self, number};

/// Width of a whole figure, px.
pub(super) const WIDTH: f64 = 720.0;

/// A text of this size, px, held at a place by its `start`, `middle` or `end`.
pub(super) fn words(words: &str, [x, y]: [f64; 2], size: f64, anchor: &str) -> String {
    if words.is_empty() {
        return String::new();
    }
    let [x, y, size] = [x, y, size].map(number);
    let words = text::svg(&text::escape(words));
    format!(r#"<text x="{x}" y="{y}" font-size="{size}" text-anchor="{anchor}">{words}</text>"#)
}

/// A stroke along `outline`.
pub(super) fn path(outline: &str, attributes: &str) -> String {
    format!(r#"<path d="{outline}" fill="none" {attributes}/>"#)
}

/// Areas within `outline`.
pub(super) fn filled(outline: &str, attributes: &str) -> String {
    format!(r#"<path d="{outline}" {attributes}/>"#)
}

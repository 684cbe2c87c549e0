//! The little markup of captions, labels and cells: `x_{eq}`, `10^{5}` and `*emphasis*`.

use std::fmt::Write;

/// How one format opens and closes each kind of span.
struct Dialect {
    subscript: [&'static str; 2],
    superscript: [&'static str; 2],
    emphasis: [&'static str; 2],
}

const HTML: Dialect = Dialect {
    subscript: ["<sub>", "</sub>"],
    superscript: ["<sup>", "</sup>"],
    emphasis: ["<em>", "</em>"],
};

// `baseline-shift` is not drawn by every browser; `dy` is, but must be taken back by hand.
const SVG: Dialect = Dialect {
    subscript: [
        r#"<tspan dy="0.3em" font-size="75%">"#,
        r#"</tspan><tspan dy="-0.225em">&#8203;</tspan>"#,
    ],
    superscript: [
        r#"<tspan dy="-0.45em" font-size="75%">"#,
        r#"</tspan><tspan dy="0.3375em">&#8203;</tspan>"#,
    ],
    emphasis: [r#"<tspan font-style="italic">"#, "</tspan>"],
};

const PLAIN: Dialect = Dialect {
    subscript: ["_", ""],
    superscript: ["^", ""],
    emphasis: ["", ""],
};

/// Between these marks the letters are smaller.
const SIZES: Dialect = Dialect {
    subscript: ["\u{1}", "\u{2}"],
    superscript: ["\u{1}", "\u{2}"],
    emphasis: ["", ""],
};

/// As HTML, escaped.
pub(super) fn html(text: &str) -> String {
    convert(&escape(text), &HTML)
}

/// As the content of an SVG text element; `text` must be escaped already.
pub(super) fn svg(text: &str) -> String {
    convert(text, &SVG)
}

/// Without markup, for file names' sake and for data.
pub(super) fn plain(text: &str) -> String {
    convert(text, &PLAIN)
}

/// The width of a line of text, in units of its size: as Helvetica sets it, within a few hundredths.
pub(super) fn width(text: &str) -> f64 {
    let mut size = 1.0;
    let advance = |letter| match letter {
        '\u{1}' | '\u{2}' => {
            size = if letter == '\u{1}' { 0.75 } else { 1.0 };
            0.0
        }
        letter => size * breadth(letter),
    };
    convert(text, &SIZES).chars().map(advance).sum()
}

const fn breadth(letter: char) -> f64 {
    match letter {
        'i' | 'j' | 'l' | '|' | '′' => 0.24,
        ' ' | 'f' | 't' | 'I' | '.' | ',' | ':' | ';' | '/' | '·' => 0.28,
        'r' | '(' | ')' | '-' => 0.33,
        'c' | 'k' | 's' | 'v' | 'x' | 'y' | 'z' | 'J' => 0.5,
        '=' | '−' | '×' => 0.584,
        'm' | 'M' | 'W' => 0.85,
        'w' | 'A'..='Z' => 0.7,
        _ => 0.556,
    }
}

/// Escapes what XML keeps for itself.
pub(super) fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

fn convert(text: &str, dialect: &Dialect) -> String {
    let mut out = String::with_capacity(text.len());
    let mut open: Option<[&str; 2]> = None;
    let mut emphasised = false;
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let (spans, taken) = match (first, open) {
            ('_', None) if rest[1..].starts_with('{') => (Some(dialect.subscript), 2),
            ('^', None) if rest[1..].starts_with('{') => (Some(dialect.superscript), 2),
            _ => (None, first.len_utf8()),
        };
        match (spans, first, open) {
            (Some(span), _, _) => {
                out.push_str(span[0]);
                open = Some(span);
            }
            (None, '}', Some(span)) => {
                out.push_str(span[1]);
                open = None;
            }
            (None, '*', _) if emphasised || begins_emphasis(text, rest) => {
                out.push_str(dialect.emphasis[usize::from(emphasised)]);
                emphasised = !emphasised;
            }
            _ => out.push(first),
        }
        rest = &rest[taken..];
    }
    out
}

/// Whether the `*` with which `rest` begins opens emphasis, as in `2*ζ*`: not that of a product, as in `N*m` or `m^2*s`.
fn begins_emphasis(text: &str, rest: &str) -> bool {
    let before = &text[..text.len() - rest.len()];
    let before = before.trim_end_matches(|c: char| c.is_ascii_digit());
    let joined = |c: char| c.is_alphanumeric() || c == '^';
    !before.chars().next_back().is_some_and(joined) && rest[1..].contains('*')
}

/// A number for a drawing: two decimals, no trailing zeros.
pub(super) fn number(value: f64) -> String {
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = write!(text, "{value:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_dialect_says_the_same() {
        let text = "*v_{dr}* < 10^{-3}";
        assert_eq!(html(text), "<em>v<sub>dr</sub></em> &lt; 10<sup>-3</sup>");
        assert_eq!(plain(text), "v_dr < 10^-3");
        assert!((width("10^{−3}") - (2.0 + 0.75) * 0.556 - 0.75 * 0.584).abs() < 1e-12);
        assert!(svg("v_{dr}").starts_with(r#"v<tspan dy="0.3em""#));
    }

    #[test]
    fn a_product_of_units_is_no_emphasis() {
        for text in [
            "T (N*m)",
            "T, c (N*m*s)",
            "F (N*m), G (kg*m^2*s*K)",
            "2 * x",
        ] {
            assert_eq!(svg(text), text);
        }
        assert_eq!(html("*M* in N*m"), "<em>M</em> in N*m");
        assert_eq!(html("2*ζ* + 4*ε*"), "2<em>ζ</em> + 4<em>ε</em>");
    }
}

//! Lines of text.

use pdf_writer::{Content, Str};
use roxmltree::Node;

use super::attributes::number;
use super::letters::{FONTS, digit, letter};
use crate::report::text::width;

/// Letters of one font and size, and how far above the line they stand.
struct Run {
    font: usize,
    size: f32,
    rise: f32,
    letters: Vec<u8>,
}

/// How a part of a text is set.
#[derive(Clone, Copy)]
struct Style {
    size: f32,
    oblique: bool,
}

/// Writes a line of text where it is held by its start, its middle or its end.
pub(super) fn write(node: Node<'_, '_>, content: &mut Content) {
    let size = number(node, "font-size");
    let (mut runs, mut rise) = (Vec::new(), 0.0);
    let style = Style {
        size,
        oblique: false,
    };
    collect(node, style, &mut rise, &mut runs);
    let whole: f32 = runs
        .iter()
        .map(|(run, text): &(Run, String)| run.size * width(text) as f32)
        .sum();
    let before = match node.attribute("text-anchor") {
        Some("middle") => 0.5 * whole,
        Some("end") => whole,
        _ => 0.0,
    };
    let [x, y] = ["x", "y"].map(|name| number(node, name));
    content.begin_text();
    // The page is turned upside down, and letters must not be.
    content.set_text_matrix([1.0, 0.0, 0.0, -1.0, x - before, y]);
    for (run, _) in &runs {
        content.set_font(FONTS[run.font].0, run.size);
        content.set_rise(run.rise);
        content.show(Str(&run.letters));
    }
    content.end_text();
}

/// The runs of a text and of what stands in it, in their order.
fn collect(node: Node<'_, '_>, style: Style, rise: &mut f32, runs: &mut Vec<(Run, String)>) {
    for child in node.children() {
        if let Some(text) = child.text().filter(|_| child.is_text()) {
            text.chars()
                .filter(|c| *c != '\u{200b}')
                .for_each(|c| add(c, style, *rise, runs));
        }
        if child.is_element() {
            let small = child.attribute("font-size") == Some("75%");
            let size = if small { 0.75 * style.size } else { style.size };
            let lowered = child.attribute("dy").and_then(|dy| dy.strip_suffix("em"));
            *rise -= size * lowered.and_then(|dy| dy.parse().ok()).unwrap_or(0.0);
            let oblique = style.oblique || child.attribute("font-style") == Some("italic");
            collect(child, Style { size, oblique }, rise, runs);
        }
    }
}

fn add(written: char, style: Style, rise: f32, runs: &mut Vec<(Run, String)>) {
    let (written, size, rise) = match digit(written) {
        Some((digit, _)) => (digit, 0.75 * style.size, rise - 0.2 * style.size),
        None => (written, style.size, rise),
    };
    let (symbol, code) = letter(written);
    let font = if symbol {
        2
    } else {
        usize::from(style.oblique)
    };
    let same =
        |(run, _): &&mut (Run, String)| run.font == font && run.size == size && run.rise == rise;
    match runs.last_mut().filter(same) {
        Some((run, text)) => {
            run.letters.push(code);
            text.push(written);
        }
        None => {
            let letters = vec![code];
            let run = Run {
                font,
                size,
                rise,
                letters,
            };
            runs.push((run, written.to_string()));
        }
    }
}

//! Figures as SVG: real text, colours that colour-blind readers can tell apart, dashes that survive a printer.

mod curve;
mod frame;
mod legend;
mod scale;
mod ticks;

use super::figure::Figure;
use super::text::{self, number};
use frame::Frame;

/// Fonts that nearly every reader has, of equal widths.
const FONTS: &str = "Helvetica Neue, Helvetica, Arial, Liberation Sans, sans-serif";

/// Width of a whole figure, px.
const WIDTH: f64 = 720.0;
/// Height of a row of panels, px, by how many stand side by side.
const HEIGHTS: [f64; 3] = [400.0, 330.0, 260.0];
/// Height of the titles of panels, px.
const TITLE: f64 = 22.0;

/// A figure as a standalone SVG document.
pub(super) fn draw(figure: &Figure) -> String {
    let columns = figure.columns.min(figure.panels.len()).max(1);
    let height = HEIGHTS[columns.min(HEIGHTS.len()) - 1];
    let titled = figure.panels.iter().any(|panel| !panel.title.is_empty());
    let title = if titled { TITLE } else { 0.0 };
    let margins = figure.panels.iter();
    let margin = margins.map(|panel| frame::margin(panel, height));
    let margin = margin.fold(0.0, f64::max);
    let (mut body, top) = legend::draw(figure, margin);
    for (i, panel) in figure.panels.iter().enumerate() {
        let (row, column) = ((i / columns) as f64, (i % columns) as f64);
        let width = WIDTH / columns as f64;
        let corner = [column * width, top + row * (title + height) + title];
        let frame = Frame::new(panel, corner, [width, height], margin);
        body += &frame.draw(&figure.panel_name(i));
    }
    let rows = figure.panels.len().div_ceil(columns) as f64;
    let [width, height] = [WIDTH, top + rows * (title + height)].map(number);
    format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" role="img" font-family="{FONTS}"><title>{}</title><rect width="100%" height="100%" fill="white"/>{body}</svg>"#,
        text::escape(&text::plain(&figure.title)),
    )
}

/// A text of this size, px, held at a place by its `start`, `middle` or `end`.
fn words(words: &str, [x, y]: [f64; 2], size: f64, anchor: &str) -> String {
    if words.is_empty() {
        return String::new();
    }
    let [x, y, size] = [x, y, size].map(number);
    let words = text::svg(&text::escape(words));
    format!(r#"<text x="{x}" y="{y}" font-size="{size}" text-anchor="{anchor}">{words}</text>"#)
}

/// A stroke along `outline`.
fn path(outline: &str, attributes: &str) -> String {
    format!(r#"<path d="{outline}" fill="none" {attributes}/>"#)
}

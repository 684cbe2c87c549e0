//! Figures as SVG: real text, colours that colour-blind readers can tell apart, dashes that survive a printer.

mod beside;
mod curve;
mod element;
mod frame;
mod legend;
mod scale;
mod smooth;
mod ticks;
mod vector;
mod view;

use super::figure::Figure;
use super::text::{self, number};
use element::WIDTH;
use frame::Frame;

/// Fonts that nearly every reader has, of equal widths.
const FONTS: &str = "Helvetica Neue, Helvetica, Arial, Liberation Sans, sans-serif";

/// Height of a row of panels, px, by how many stand side by side.
const HEIGHTS: [f64; 3] = [400.0, 330.0, 260.0];
/// Height of the titles of panels, px.
const TITLE: f64 = 22.0;

impl Figure {
    /// The figure as a standalone SVG document.
    #[must_use]
    pub fn svg(&self) -> String {
        let columns = self.columns.min(self.panels.len()).max(1);
        let height = HEIGHTS[columns.min(HEIGHTS.len()) - 1];
        let titled = self.panels.iter().any(|panel| !panel.title.is_empty());
        let title = if titled { TITLE } else { 0.0 };
        let margins = self.panels.iter();
        let margin = margins.map(|panel| frame::margin(panel, height));
        let margin = margin.fold(0.0, f64::max);
        let width = WIDTH / columns as f64;
        // Above the first column in which anything is named.
        let named = self
            .panels
            .iter()
            .enumerate()
            .filter(|(_, panel)| panel.is_named());
        let first = named.map(|(i, _)| i % columns).min().unwrap_or(0);
        let (mut body, top) = legend::draw(self, margin + first as f64 * width);
        for (i, panel) in self.panels.iter().enumerate() {
            let (row, column) = ((i / columns) as f64, (i % columns) as f64);
            let corner = [column * width, top + row * (title + height) + title];
            let frame = Frame::new(panel, corner, [width, height], margin);
            body += &frame.draw(&self.panel_name(i));
        }
        let rows = self.panels.len().div_ceil(columns) as f64;
        let [width, height] = [WIDTH, top + rows * (title + height)].map(number);
        format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" role="img" font-family="{FONTS}"><title>{}</title><rect width="100%" height="100%" fill="white"/>{body}</svg>"#,
            text::escape(&text::plain(&self.title)),
        )
    }
}

#[cfg(test)]
pub(super) mod contrast;

//! Figures as SVG: real text, colours that colour-blind readers can tell apart, dashes that survive a printer.

use kuva::backend::svg::SvgBackend;
use kuva::plot::{LinePlot, MarkerShape, ScatterPlot};
use kuva::render::layout::{Layout, TickAlign, TickFormat};
use kuva::render::plots::Plot;
use kuva::render::render::render_multiple;

use super::figure::{Axis, Curve, Figure, Marker, Panel, Shape};
use super::text;

/// Colours of Okabe and Ito, without their yellow, which paper does not show.
const COLOURS: [&str; 7] = [
    "#000000", "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9",
];
/// Dash patterns that go with them.
const DASHES: [&str; 7] = [
    "",
    "7 3",
    "7 3 1.5 3",
    "2.5 2.5",
    "12 3",
    "12 3 2 3 2 3",
    "",
];
/// Fonts that nearly every reader has.
const FONTS: &str = "Helvetica Neue, Helvetica, Arial, Liberation Sans, sans-serif";

/// Width of a whole figure, px.
const WIDTH: f64 = 720.0;
/// Height of a row of panels, px, by how many stand side by side.
const HEIGHTS: [f64; 3] = [400.0, 330.0, 260.0];
/// Radius of a dot, px.
const DOT: f64 = 1.1;
const LEGEND_ROW: f64 = 20.0;
const SWATCH: f64 = 30.0;
const TITLE: f64 = 22.0;
/// Average width of a letter in the legend, px: the widest fonts of the stack.
const LETTER: f64 = 6.9;

/// A figure as a standalone SVG document.
pub(super) fn draw(figure: &Figure) -> String {
    let (legend, top) = legend(figure);
    let columns = figure.columns.min(figure.panels.len()).max(1);
    let height = HEIGHTS[columns.min(HEIGHTS.len()) - 1];
    let (mut body, mut bottom) = (legend, top);
    for (i, panel) in figure.panels.iter().enumerate() {
        let (row, column) = (i / columns, i % columns);
        let title = if panel.title.is_empty() { 0.0 } else { TITLE };
        let width = WIDTH / columns as f64;
        let (x, y) = (column as f64 * width, top + row as f64 * (height + title));
        body += &heading(panel, x + 0.5 * width, y);
        body += &placed(
            &chart(panel, width, height),
            x,
            y + title,
            &figure.panel_name(i),
        );
        bottom = y + title + height;
    }
    format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {} {}" width="{}" height="{}" role="img" font-family="{FONTS}"><title>{}</title>{body}</svg>"#,
        text::number(WIDTH),
        text::number(bottom),
        text::number(WIDTH),
        text::number(bottom),
        text::escape(&text::plain(&figure.title)),
    )
}

fn heading(panel: &Panel, x: f64, y: f64) -> String {
    if panel.title.is_empty() {
        return String::new();
    }
    format!(
        r#"<text x="{}" y="{}" font-size="13" text-anchor="middle">{}</text>"#,
        text::number(x),
        text::number(y + 16.0),
        text::svg(&text::escape(&panel.title)),
    )
}

/// Puts a chart into the figure. Its clip paths get the panel's name: identifiers hold for a whole page.
fn placed(chart: &str, x: f64, y: f64, name: &str) -> String {
    let place = format!(r#"<svg x="{}" y="{}" "#, text::number(x), text::number(y));
    text::svg(chart)
        // A tick below zero deserves a minus sign and not a hyphen.
        .replace(">-", ">−")
        .replacen(r#"<svg xmlns="http://www.w3.org/2000/svg" "#, &place, 1)
        .replace("kuva-clip-", &format!("{name}-clip-"))
}

fn chart(panel: &Panel, width: f64, height: f64) -> String {
    let plots: Vec<Plot> = panel.curves.iter().map(plot).collect();
    let mut layout = Layout::auto_from_plots(&plots)
        .with_width(width)
        .with_height(height)
        .with_x_label(&panel.x.label)
        .with_y_label(&panel.y.label)
        .with_font_family(FONTS)
        .with_box_axes()
        .with_tick_align(TickAlign::Inside)
        .with_label_size(13)
        .with_tick_size(11)
        .with_grid_line_width(0.5)
        .with_axis_line_width(0.8)
        .with_tick_width(0.8)
        .with_x_tick_format(ticks(&panel.x))
        .with_y_tick_format(ticks(&panel.y));
    if let Some([low, high]) = panel.x.range {
        layout = layout.with_x_axis_min(low).with_x_axis_max(high);
    }
    if let Some([low, high]) = panel.y.range {
        layout = layout.with_y_axis_min(low).with_y_axis_max(high);
    }
    if panel.x.logarithmic {
        layout = layout.with_log_x();
    }
    if panel.y.logarithmic {
        layout = layout.with_log_y();
    }
    SvgBackend::new().render_scene(&render_multiple(plots, layout))
}

/// On a logarithmic axis only the decades are labelled, as powers.
fn ticks(axis: &Axis) -> TickFormat {
    if !axis.logarithmic {
        return TickFormat::Auto;
    }
    TickFormat::Custom(std::sync::Arc::new(|value: f64| {
        let power = value.log10();
        if (power - power.round()).abs() < 1e-6 {
            format!("10^{{{}}}", power.round())
        } else {
            String::new()
        }
    }))
}

fn plot(curve: &Curve) -> Plot {
    let colour = COLOURS[curve.series % COLOURS.len()];
    let points = curve.points.iter().map(|&[x, y]| (x, y));
    match curve.shape {
        Shape::Line => {
            let line = LinePlot::new()
                .with_data(points)
                .with_color(colour)
                .with_stroke_width(1.5);
            let dashes = DASHES[curve.series % DASHES.len()];
            Plot::Line(if dashes.is_empty() {
                line
            } else {
                line.with_line_style(kuva::plot::LineStyle::Custom(dashes.to_owned()))
            })
        }
        Shape::Points(Marker::Dot) => Plot::Scatter(
            ScatterPlot::new()
                .with_data(points)
                .with_color(colour)
                .with_size(DOT),
        ),
        Shape::Points(marker) => Plot::Scatter(
            ScatterPlot::new()
                .with_data(points)
                .with_color(colour)
                .with_marker(shape(marker))
                .with_size(4.5)
                .with_marker_opacity(0.0)
                .with_marker_stroke_width(1.4),
        ),
    }
}

const fn shape(marker: Marker) -> MarkerShape {
    match marker {
        Marker::Circle | Marker::Dot => MarkerShape::Circle,
        Marker::Cross => MarkerShape::Cross,
        Marker::Diamond => MarkerShape::Diamond,
    }
}

/// One legend for all panels, above them where it covers no data; and where it ends.
fn legend(figure: &Figure) -> (String, f64) {
    let mut entries: Vec<&Curve> = Vec::new();
    for curve in figure.panels.iter().flat_map(|panel| &panel.curves) {
        if !curve.label.is_empty() && !entries.iter().any(|entry| entry.label == curve.label) {
            entries.push(curve);
        }
    }
    let (mut body, mut x, mut y) = (String::new(), 60.0, 14.0);
    for entry in &entries {
        let width = SWATCH + 8.0 + LETTER * text::plain(&entry.label).chars().count() as f64;
        if x + width > WIDTH && x > 60.0 {
            (x, y) = (60.0, y + LEGEND_ROW);
        }
        body += &swatch(entry, x, y);
        body += &format!(
            r#"<text x="{}" y="{}" font-size="12.5">{}</text>"#,
            text::number(x + SWATCH + 8.0),
            text::number(y + 4.0),
            text::svg(&text::escape(&entry.label)),
        );
        x += width + 18.0;
    }
    let end = if entries.is_empty() {
        0.0
    } else {
        y + LEGEND_ROW
    };
    (body, end)
}

fn swatch(curve: &Curve, x: f64, y: f64) -> String {
    let colour = COLOURS[curve.series % COLOURS.len()];
    let (left, middle, right) = (x, x + 0.5 * SWATCH, x + SWATCH);
    let path = match curve.shape {
        Shape::Line => format!("M{left} {y}H{right}"),
        Shape::Points(Marker::Circle) => {
            format!("M{} {y}a4.5 4.5 0 1 0 9 0a4.5 4.5 0 1 0 -9 0", middle - 4.5)
        }
        Shape::Points(Marker::Dot) => {
            let left = middle - DOT;
            format!("M{left} {y}a{DOT} {DOT} 0 1 0 2.2 0a{DOT} {DOT} 0 1 0 -2.2 0")
        }
        Shape::Points(Marker::Cross) => format!(
            "M{0} {1}L{2} {3}M{0} {3}L{2} {1}",
            middle - 4.0,
            y - 4.0,
            middle + 4.0,
            y + 4.0
        ),
        Shape::Points(Marker::Diamond) => {
            format!("M{} {y}l4.5 -4.5l4.5 4.5l-4.5 4.5z", middle - 4.5)
        }
    };
    let dashes = match curve.shape {
        Shape::Line => DASHES[curve.series % DASHES.len()],
        Shape::Points(_) => "",
    };
    format!(
        r#"<path d="{path}" fill="none" stroke="{colour}" stroke-width="1.5" stroke-dasharray="{dashes}"/>"#
    )
}

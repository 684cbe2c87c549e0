//! Curves as they are drawn, in panels and in the legend.

use super::element::{filled, path};
use super::smooth::{Knot, smooth};
use super::view::View;
use crate::report::curve::{COLOURS, Curve, Marker, SHADES, Shape};
use crate::report::text::number;

/// Black and three colours of Okabe and Ito, then such as stand out on white paper and differ from them and from each
/// other to every kind of colour blindness.
const COLOUR: [&str; COLOURS] = [
    "#000000", "#0072B2", "#D55E00", "#009E73", "#771C64", "#564F00", "#3902D4",
];
/// Shades from small values to large ones, of nearly equal steps to every eye, also in grey: Matplotlib's `inferno` as far as
/// it stands out on white paper.
const SHADING: [&str; SHADES] = [
    "#050417", "#1e0c45", "#420a68", "#62146e", "#84206b", "#a32c61", "#c13a50", "#dd513a",
    "#ef6e21",
];
/// Dash patterns that go with them.
const DASHES: [&str; 7] = [
    "none",
    "7 3",
    "7 3 1.5 3",
    "2.5 2.5",
    "12 3",
    "12 3 2 3 2 3",
    "4 2 1 2",
];
/// Half the size of a marker, px.
pub(super) const MARKER: f64 = 4.2;
/// By how much neighbouring tiles overlap, so that no gap shows between them, px.
const OVERLAP: f64 = 0.3;
/// Height of a tile in the legend, px.
const SWATCH: f64 = 11.0;
/// The size of a dot, px.
const DOT: f64 = 3.0;
/// The size of a speck, px.
const SPECK: f64 = 1.6;

/// A curve in a frame, cut off by `clip`; markers are drawn whole, where the frame holds their places.
pub(super) fn draw(curve: &Curve, frame: &View, clip: &str) -> String {
    let places = curve.points.iter().map(|point| frame.place(*point));
    let clipped = || format!(r#"{} clip-path="url(#{clip})""#, style(curve));
    match curve.shape {
        Shape::Line => path(&line(places), &clipped()),
        Shape::Smooth => path(&smooth(&knots(curve, frame)), &clipped()),
        Shape::Points(marker) => {
            let seen = places.filter(|place| frame.holds(*place));
            let outlines: String = seen.map(|place| outline(marker, place)).collect();
            path(&outlines, &style(curve))
        }
        Shape::Tiles { fill, shade } => {
            let size = frame.size();
            let size = [0, 1].map(|k| size[k] / fill[k].max(1) as f64 + OVERLAP);
            let tiles: String = places.map(|place| tile(place, size)).collect();
            filled(
                &tiles,
                &format!(
                    r#"fill="{}" clip-path="url(#{clip})""#,
                    fill_of(curve, shade)
                ),
            )
        }
    }
}

fn knots(curve: &Curve, frame: &View) -> Vec<Knot> {
    let known = |i: usize, point: &[f64; 2]| {
        let direction = frame.direction(*point, *curve.directions.get(i)?);
        let size = direction[0].hypot(direction[1]);
        (size.is_finite() && size > 0.0).then_some(direction)
    };
    let points = curve.points.iter().enumerate();
    points
        .map(|(i, point)| Knot {
            place: frame.place(*point),
            directions: [known(i, point); 2],
            times: [curve.times.get(i).copied(); 2],
        })
        .collect()
}

/// The colour of tiles.
fn fill_of(curve: &Curve, shade: Option<usize>) -> &'static str {
    shade.map_or(look(curve.series).0, |shade| SHADING[shade.min(SHADES - 1)])
}

/// A tile of this size around a place; nothing if that is nowhere.
fn tile([x, y]: [f64; 2], [width, height]: [f64; 2]) -> String {
    if !(x.is_finite() && y.is_finite()) {
        return String::new();
    }
    let [left, top] = [x - 0.5 * width, y - 0.5 * height].map(number);
    let [width, height] = [width, height].map(number);
    format!("M{left} {top}h{width}v{height}h-{width}z")
}

/// A curve in the legend, from here on for `length` px.
pub(super) fn sample(curve: &Curve, [x, y]: [f64; 2], length: f64) -> String {
    let outline = match curve.shape {
        Shape::Tiles { shade, .. } => {
            let swatch = tile([x + 0.5 * length, y], [0.6 * length, SWATCH]);
            return filled(&swatch, &format!(r#"fill="{}""#, fill_of(curve, shade)));
        }
        Shape::Line | Shape::Smooth => line([[x, y], [x + length, y]].into_iter()),
        Shape::Points(marker) => outline(marker, [x + 0.5 * length, y]),
    };
    path(&outline, &style(curve))
}

fn style(curve: &Curve) -> String {
    let (colour, dashes) = look(curve.series);
    match curve.shape {
        Shape::Line | Shape::Smooth => format!(
            r#"stroke="{colour}" stroke-width="1.5" stroke-linejoin="round" stroke-dasharray="{dashes}""#
        ),
        Shape::Points(Marker::Dot) => round(colour, DOT),
        Shape::Points(Marker::Speck) => round(colour, SPECK),
        Shape::Points(_) | Shape::Tiles { .. } => {
            format!(r#"stroke="{colour}" stroke-width="1.5""#)
        }
    }
}

fn round(colour: &str, size: f64) -> String {
    format!(r#"stroke="{colour}" stroke-width="{size}" stroke-linecap="round""#)
}

/// The colour and the dashes of a series; as many differ as there are pairs of both.
const fn look(series: usize) -> (&'static str, &'static str) {
    let round = series / COLOURS;
    (
        COLOUR[series % COLOURS],
        DASHES[(series + round) % DASHES.len()],
    )
}

/// A line through places, with gaps where there is none.
fn line(places: impl Iterator<Item = [f64; 2]>) -> String {
    let (mut line, mut pen) = (String::new(), 'M');
    for place in places {
        if place.iter().all(|at| at.is_finite()) {
            let [x, y] = place.map(number);
            line += &format!("{pen}{x} {y}");
            pen = 'L';
        } else {
            pen = 'M';
        }
    }
    line
}

/// A marker; a dot is a stroke without length, of which its round ends are seen.
fn outline(marker: Marker, [x, y]: [f64; 2]) -> String {
    let [left, top, x, y] = [x - MARKER, y - MARKER, x, y].map(number);
    let (half, whole) = (MARKER, 2.0 * MARKER);
    match marker {
        Marker::Circle => {
            format!("M{left} {y}a{half} {half} 0 1 0 {whole} 0a{half} {half} 0 1 0 -{whole} 0z")
        }
        Marker::Cross => format!("M{left} {top}l{whole} {whole}m0 -{whole}l-{whole} {whole}"),
        Marker::Plus => format!("M{left} {y}h{whole}M{x} {top}v{whole}"),
        Marker::Square => format!("M{left} {top}h{whole}v{whole}h-{whole}z"),
        Marker::Triangle => format!("M{x} {top}l{half} {whole}h-{whole}z"),
        Marker::Diamond => format!("M{left} {y}l{half} -{half}l{half} {half}l-{half} {half}z"),
        Marker::Dot | Marker::Speck => format!("M{x} {y}h0"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    use crate::report::draw::contrast::{contrast, luminance};

    #[test]
    fn every_colour_stands_out_on_white() {
        for colour in COLOUR.into_iter().chain(SHADING) {
            assert!(contrast(colour, "#ffffff") >= 3.0, "{colour}");
        }
        assert!(contrast("#ffffff", "#000000") > 20.9);
        assert!(contrast("#949494", "#ffffff") >= 3.0 && contrast("#969696", "#ffffff") < 3.0);
    }

    #[test]
    fn series_and_shades_differ_in_grey() {
        for (i, dashes) in DASHES.iter().enumerate() {
            assert!(!DASHES[i + 1..].contains(dashes), "{dashes}");
        }
        // The shades of a map grow lighter step by step.
        let mut steps = SHADING.windows(2);
        assert!(steps.all(|pair| luminance(pair[0]) < luminance(pair[1])));
    }

    #[test]
    fn no_two_series_look_the_same() {
        let looks: std::collections::HashSet<_> = (0..49).map(look).collect();
        assert_eq!(looks.len(), 49);
    }

    #[test]
    fn a_line_has_gaps_where_there_are_no_values() {
        let places = [[0.0, 1.0], [2.0, 3.5], [f64::NAN, 0.0], [4.0, 5.0]];
        assert_eq!(line(places.into_iter()), "M0 1L2 3.5M4 5");
    }
}

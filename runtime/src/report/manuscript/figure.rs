//! Figures with their axes as they are written.

use super::filling::{Filling, joined};
use crate::report::{Axis, Curve, Figure, Inset, Panel};

/// A figure of the panels that its axes and curves make, or of those that are given.
pub(super) fn figure(place: &str, number: &str, text: &str, filling: Filling) -> Option<Figure> {
    let (head, title) = place.split_once(": ")?;
    let abreast = head
        .split_once(", ")
        .map_or(Some("1"), |(_, abreast)| abreast.strip_suffix(" abreast"))?;
    let lines = |prefix: &'static str| {
        text.lines()
            .filter_map(move |line| line.strip_prefix(prefix))
    };
    let axes: Vec<(&str, &str)> = lines("x: ").zip(lines("y: ")).collect();
    let panels = match filling {
        Filling::Panels(panels) if axes.is_empty() => panels,
        Filling::Curves(all) if axes.len() == all.len() => {
            let enlarged: Option<Vec<Inset>> = lines("inset: ").map(inset).collect();
            let enlarged = enlarged?;
            let panel = |((x, y), curves): ((&str, &str), Vec<Curve>)| Panel {
                inset: enlarged.first().cloned(),
                ..Panel::new(axis(x), axis(y)).curves(curves)
            };
            axes.into_iter().zip(all).map(panel).collect()
        }
        _ => return None,
    };
    let caption = text.lines();
    let axes = ["x: ", "y: ", "inset: "];
    let caption = caption.filter(|line| !axes.iter().any(|axis| line.starts_with(axis)));
    let figure = Figure::new(number, title, joined(caption)).columns(abreast.parse().ok()?);
    Some(panels.into_iter().fold(figure, Figure::panel))
}

/// `0 to 0.1, 2 to 3 at 0.6 0.1 0.9 0.4`.
fn inset(text: &str) -> Option<Inset> {
    let (what, place) = text.split_once(" at ")?;
    let (x, y) = what.split_once(", ")?;
    let range = |text: &str| {
        let (low, high) = text.split_once(" to ")?;
        Some([low.parse().ok()?, high.parse().ok()?])
    };
    let place: Vec<f64> = place.split(' ').flat_map(str::parse).collect();
    Some(Inset {
        x: range(x)?,
        y: range(y)?,
        place: place.try_into().ok()?,
    })
}

fn axis(text: &str) -> Axis {
    let (text, logarithmic) = match text.strip_suffix(", logarithmic") {
        Some(text) => (text, true),
        None => (text, false),
    };
    let ends = text.rsplit_once(" from ").and_then(|(label, ends)| {
        let (low, high) = ends.split_once(" to ")?;
        Some((label, [low.parse().ok()?, high.parse().ok()?]))
    });
    Axis {
        label: ends.map_or(text, |(label, _)| label).to_owned(),
        range: ends.map(|(_, ends)| ends),
        logarithmic,
        counts: false,
    }
}

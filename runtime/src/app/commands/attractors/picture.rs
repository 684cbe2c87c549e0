//! Basins in a plane of two states, or shares along what is followed.

use super::branches;
use crate::app::axis::{along_axis, axis};
use crate::app::text::brief;
use crate::model::ModelInfo;
use crate::report::{Axis, COLOURS, Curve, Figure, Marker, Panel};
use crate::study::{Along, AttractorsRecord, Class, FollowedRecord, Survey};

/// Starts that are drawn at most: the first ones fill the region evenly, too.
const DRAWN: usize = 20_000;
/// How they are drawn, where there are more motions than colours.
const MARKERS: [Marker; 4] = [Marker::Dot, Marker::Plus, Marker::Cross, Marker::Triangle];

pub(super) fn picture(
    info: &ModelInfo,
    (record, followed): (&AttractorsRecord, Option<&FollowedRecord>),
    shown: [usize; 2],
) -> Figure {
    match (&record.along, record.surveys.first()) {
        (Some(along), _) => {
            let figure = shares(info, record, along);
            match followed {
                Some(followed) => {
                    let branches = branches::panel(info, along, followed, shown[0]);
                    figure.columns(2).panel(branches)
                }
                None => figure,
            }
        }
        (None, survey) => basins(info, record, shown, survey),
    }
}

fn basins(
    info: &ModelInfo,
    record: &AttractorsRecord,
    shown: [usize; 2],
    survey: Option<&Survey>,
) -> Figure {
    let title = format!("{}: basins of attraction", info.command);
    let caption = format!(
        "{} starts, each in the colour of the motion on which it settles.",
        record.sampling.starts
    );
    let [x, y] = shown.map(|state| {
        let axis = info
            .states
            .get(state)
            .map_or_else(|| Axis::new(""), |one| axis(one.name, one.unit));
        let side = record
            .sampling
            .region
            .sides
            .iter()
            .find(|side| side.state == state);
        side.map_or(axis.clone(), |side| axis.from(side.low, side.high))
    });
    let found = survey.map_or(&[][..], |survey| &survey.found);
    let starts = survey.map_or(&[][..], |survey| &survey.starts);
    let at = |state: &[f64]| shown.map(|j| state.get(j).copied().unwrap_or(f64::NAN));
    let clouds = found.iter().enumerate().map(|(number, one)| {
        let all = starts.iter().take(DRAWN).filter(|(_, of)| *of == number);
        let points = all.map(|(start, _)| at(start)).collect();
        let label = format!(
            "{} ({:.2} %)",
            brief(&one.attractor.name()),
            100.0 * one.share
        );
        let marker = MARKERS[(number / (COLOURS - 1)) % MARKERS.len()];
        Curve::points(label, 1 + number % (COLOURS - 1), marker, points)
    });
    let resting = found
        .iter()
        .filter(|one| one.attractor.class == Class::Equilibrium);
    let resting = resting
        .map(|one| at(&one.attractor.state))
        .collect::<Vec<_>>();
    let panel = Panel::new(x, y).curves(clouds);
    let panel = match resting.is_empty() {
        true => panel,
        false => panel.curve(Curve::points("equilibrium", 0, Marker::Diamond, resting)),
    };
    Figure::new("1", &title, caption).panel(panel)
}

/// The share of each kind of motion along what is followed: motions with one word are one kind.
fn shares(info: &ModelInfo, record: &AttractorsRecord, along: &Along) -> Figure {
    let title = format!("{}: shares of motions", info.command);
    let caption = format!(
        "{} starts at each of {} values.",
        record.sampling.starts,
        record.surveys.len()
    );
    let mut names: Vec<String> = Vec::new();
    for found in record.surveys.iter().flat_map(|survey| &survey.found) {
        let name = brief(&found.attractor.name());
        if !names.contains(&name) {
            names.push(name);
        }
    }
    let share = |survey: &Survey, wanted: &String| {
        let found = survey
            .found
            .iter()
            .filter(|one| brief(&one.attractor.name()) == *wanted);
        Some([survey.r?, found.map(|one| one.share).sum::<f64>()])
    };
    let curves = names.iter().enumerate().map(|(number, wanted)| {
        let points = record
            .surveys
            .iter()
            .filter_map(|survey| share(survey, wanted));
        Curve::line(wanted, number + 1, points.collect())
    });
    let panel = Panel::new(along_axis(info, along), Axis::new("share").from(0.0, 1.0));
    Figure::new("1", &title, caption).panel(panel.curves(curves))
}

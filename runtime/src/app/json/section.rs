//! Points on a section as JSON.

use super::{Named, states};
use crate::model::ModelInfo;
use crate::poincare::Crossing;
use crate::poincare::Section;

/// Where a motion meets a section.
#[derive(serde::Serialize)]
pub(in crate::app) struct Crossings<'a> {
    surface: String,
    points: Vec<Point<'a>>,
}

#[derive(serde::Serialize)]
struct Point<'a> {
    time: f64,
    rising: bool,
    state: Named<'a, f64>,
}

impl<'a> Crossings<'a> {
    pub(in crate::app) fn new(info: &'a ModelInfo, section: &Section, points: &[Crossing]) -> Self {
        let point = |point: &Crossing| Point {
            time: point.time,
            rising: point.rising,
            state: states(info, point.state.clone()),
        };
        Self {
            surface: section.describe(info),
            points: points.iter().map(point).collect(),
        }
    }
}

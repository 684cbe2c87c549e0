//! One smooth copy as JSON.

use super::super::work::Counts;
use super::super::{Named, states};
use super::{Answer, Price, price};
use crate::model::ModelInfo;
use crate::study::predict::{Prediction, ReleaseLoss};
use crate::study::trade::{Curve, Point};

#[derive(serde::Serialize)]
pub(super) struct Copy<'a> {
    smoothing: String,
    size: f64,
    stiffness: f64,
    e_f: f64,
    e_max_abs: Named<'a, f64>,
    signed: Errors<'a, f64>,
    predicted: Answer<Predicted<'a>>,
    resolution: f64,
    cost: Price,
    work: Counts,
}

#[derive(serde::Serialize)]
struct Errors<'a, T> {
    frequency: f64,
    max_abs: Named<'a, T>,
}

#[derive(serde::Serialize)]
struct Predicted<'a> {
    signed: Errors<'a, Option<f64>>,
    leading: Option<f64>,
    asymptotic: bool,
    doubts: Vec<String>,
    releases: Vec<Release>,
}

#[derive(serde::Serialize)]
struct Release {
    contact: usize,
    time: f64,
    acceleration: f64,
    compliance: f64,
    offset: f64,
    delay: f64,
    layer: f64,
}

pub(super) fn copy<'a>(info: &'a ModelInfo, curve: &Curve, point: &Point) -> Copy<'a> {
    let size: Vec<f64> = point.max_abs.iter().map(|error| error.abs()).collect();
    Copy {
        smoothing: curve.at(point.size).to_string(),
        size: point.size,
        stiffness: point.stiffness,
        e_f: point.frequency.abs(),
        e_max_abs: states(info, size),
        signed: Errors {
            frequency: point.frequency,
            max_abs: states(info, point.max_abs.clone()),
        },
        predicted: Answer::of(&point.predicted, |found| predicted(info, found)),
        resolution: point.resolution,
        cost: price(&point.cost),
        work: Counts::from(&point.found),
    }
}

fn predicted<'a>(info: &'a ModelInfo, found: &Prediction) -> Predicted<'a> {
    Predicted {
        signed: Errors {
            frequency: found.frequency,
            max_abs: states(info, found.max_abs.clone()),
        },
        leading: found.leading,
        asymptotic: found.doubts.is_empty(),
        doubts: found.doubts.clone(),
        releases: found.releases.iter().map(release).collect(),
    }
}

fn release(loss: &ReleaseLoss) -> Release {
    Release {
        contact: loss.contact,
        time: loss.time,
        acceleration: loss.acceleration,
        compliance: loss.compliance,
        offset: loss.offset,
        delay: loss.delay,
        layer: loss.layer,
    }
}

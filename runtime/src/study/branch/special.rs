//! Special points of a branch, numbered in their order.

use nalgebra::Complex;
use serde::Serialize;

use crate::continuation::{Kind, Located};
use crate::motion::Modes;
use crate::shooting::Orbit;
use crate::study::label::labels;
use crate::study::question::Along;

/// A point of a branch where something changes.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Special {
    /// What changes: `fold`, `flip`, `torus`, `grazing-sliding`, ...
    pub kind: Kind,
    /// Kind and number, for instance `PD1`.
    pub label: String,
    /// How many points of its branch precede it.
    #[serde(skip)]
    pub after: usize,
    /// The design variable, in the user's own values.
    pub r: f64,
    /// Its estimated error; none where that could not be measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error: Option<f64>,
    /// The period there.
    pub period: f64,
    /// Its estimated error; none where that was not measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub period_error: Option<f64>,
    /// The multipliers there.
    pub multipliers: Vec<Complex<f64>>,
    /// Where the orbit there begins.
    pub state: Vec<f64>,
    /// The modes in which it begins there; none for a smooth system.
    #[serde(skip)]
    pub modes: Modes,
    /// Its largest magnitude of each state.
    #[serde(skip)]
    pub max_abs: Vec<f64>,
    /// Its points on the default section, in the order of time.
    #[serde(skip)]
    pub section: Vec<Vec<f64>>,
    /// `supercritical` or `subcritical`, where that was looked at.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub criticality: Option<&'static str>,
    /// How often the orbit there is gone around while one of the branch beside it is: 2 where a doubled branch begins or
    /// ends.
    #[serde(skip)]
    pub turns: usize,
    /// What is to be said of the branch that leaves it, if it was not followed from here.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub note: Option<String>,
}

/// The special points as they are reported.
pub(in crate::study) fn numbered(along: &Along, located: &[Located<Orbit>]) -> Vec<Special> {
    let labels = labels(located.iter().map(|found| found.kind));
    let special = |(found, label): (&Located<Orbit>, String)| Special {
        kind: found.kind,
        label,
        after: found.after,
        r: along.value(found.r),
        error: along.error(found),
        period: found.point.period,
        period_error: Some(found.lasting).filter(|error| error.is_finite()),
        multipliers: found.point.floquet.multipliers.clone(),
        state: found.point.place.state.clone(),
        modes: found.point.place.modes.clone(),
        max_abs: found.point.max_abs(),
        section: found.point.section.clone(),
        criticality: None,
        turns: found.turns,
        note: None,
    };
    located.iter().zip(labels).map(special).collect()
}

//! A diagram as JSON.

use serde_json::{Value, json};

use crate::app::document::{Document, columns, value_of};
use crate::app::section::unmet;
use crate::lyapunov::Lyapunov;
use crate::model::ModelInfo;
use crate::poincare::Section;
use crate::study::{Case, DiagramRecord, Motion, Slice, SweepRecord};

/// A diagram; of one that was interrupted, how many values are not there.
pub(super) fn document<'a>(
    info: &'a ModelInfo,
    case: &Case,
    record: &DiagramRecord,
) -> Document<'a> {
    let sweep = |sweep: &SweepRecord| {
        let values = sweep
            .slices
            .iter()
            .map(|slice| value(info, &record.diagram.section, slice));
        json!({ "sweep": sweep.name, "values": values.collect::<Vec<_>>() })
    };
    let missing = (record.missing > 0).then(|| json!({ "missing": record.missing }));
    Document::case(info, case)
        .range("along", &record.along)
        .put("section", record.diagram.section.describe(info))
        .put("settle", record.diagram.settle)
        .put(
            "sweeps",
            record.sweeps.iter().map(sweep).collect::<Vec<_>>(),
        )
        .maybe("interrupted", missing)
        .units()
        .put("work", record.work())
}

/// One value of the design variable, its points as one column for each state.
fn value<'a>(info: &'a ModelInfo, section: &Section, slice: &Slice) -> Document<'a> {
    let period_count = match &slice.motion {
        Motion::Periodic(count) => Some(count),
        _ => None,
    };
    let reason = match (&slice.motion, &slice.silence) {
        (Motion::Failed(reason), _) => Some(reason.clone()),
        (_, Some(silence)) => Some(unmet(info, section, silence)),
        _ => None,
    };
    Document::new(info)
        .put("r", slice.r)
        .put("motion", slice.motion.name())
        .put("period_count", period_count)
        .states("points", columns(&slice.points, info.states.len()))
        .states("min", &slice.min)
        .states("max", &slice.max)
        .maybe("lyapunov", slice.lyapunov.as_ref().map(exponent))
        .maybe("reason", reason)
}

/// Null without a failure where the motion is superstable.
fn exponent(found: &Result<Lyapunov, String>) -> Value {
    match found {
        Ok(found) => value_of(found),
        Err(reason) => {
            json!({ "exponent": null, "error": null, "time": null, "failed": reason })
        }
    }
}

//! An orbit as JSON.

use crate::app::document::{Document, pairs};
use crate::app::harmonics;
use crate::model::ModelInfo;
use crate::study::OrbitRecord;

/// All but what it cost.
pub(in crate::app) fn document<'a>(info: &'a ModelInfo, orbit: &OrbitRecord) -> Document<'a> {
    let floquet = &orbit.floquet;
    // With a drive there is no trivial multiplier.
    let trivial = info.drive.is_none().then_some(floquet.trivial_error);
    Document::new(info)
        .maybe("r", orbit.r)
        .put("model", info.command)
        .put("dynamics", orbit.dynamics.to_string())
        .parameters(&orbit.parameters)
        .put("period", orbit.period)
        .put("frequency", 1.0 / orbit.period)
        .states("state", &orbit.state)
        .states("max", &orbit.max)
        .states("min", &orbit.min)
        .states("max_abs", &orbit.max_abs)
        .put("period_count", orbit.period_count)
        .put("multipliers", pairs(&floquet.multipliers))
        .put("log_abs_multipliers", &floquet.log_moduli)
        .put("trivial_multiplier_error", trivial)
        .put("stability", floquet.stability.name())
        .put("word", &orbit.word)
        .maybe("harmonics", harmonics::document(info, orbit))
        .units()
        .put("residual", orbit.residual)
        .put("error_estimate", orbit.error_estimate)
}

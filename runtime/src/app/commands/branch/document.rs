//! A branch as JSON.

use crate::app::commands::orbit;
use crate::app::document::Document;
use crate::field::Work;
use crate::model::ModelInfo;
use crate::study::{BranchRecord, Case};

/// A branch with those that leave it.
pub(super) fn document<'a>(
    info: &'a ModelInfo,
    case: &Case,
    branch: &BranchRecord,
) -> Document<'a> {
    let points = branch.points.iter();
    let orbits = points.map(|point| orbit::document(info, point).put("work", point.work));
    let below = branch
        .branches
        .iter()
        .map(|below| document(info, case, below));
    let mut work = Work::default();
    branch.points.iter().for_each(|point| work += point.work);
    Document::case(info, case)
        .range("along", &branch.along)
        .maybe("from", branch.from.as_ref())
        .put("points", orbits.collect::<Vec<_>>())
        .put("special", &branch.special)
        .ended(&branch.ended)
        .maybe("began", branch.began.as_ref().map(|ended| ended.word()))
        .put("branches", below.collect::<Vec<_>>())
        .units()
        .put("work", work)
}

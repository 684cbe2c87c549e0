//! A curve as JSON.

use crate::app::document::{Document, named};
use crate::model::ModelInfo;
use crate::study::{Case, CurvePointRecord, CurveRecord, SpecialCurvePoint};

/// A curve without the branch from which it starts.
pub(super) fn document<'a>(info: &'a ModelInfo, case: &Case, curve: &CurveRecord) -> Document<'a> {
    let names = [&curve.along, &curve.and].map(|range| range.name(info));
    let add = |document: Document<'a>, point: &CurvePointRecord| {
        let at = named(names.into_iter(), [point.p, point.q]);
        document.put("at", at).all(point).by_state(&["state"])
    };
    let special = |one: &SpecialCurvePoint| {
        let head = Document::new(info)
            .put("kind", one.kind)
            .put("label", &one.label);
        add(head, &one.point)
    };
    let points = curve
        .points
        .iter()
        .map(|point| add(Document::new(info), point));
    Document::case(info, case)
        .range("along", &curve.along)
        .range("and", &curve.and)
        .put("of", &curve.of)
        .put("kind", curve.kind)
        .put("points", points.collect::<Vec<_>>())
        .put(
            "special",
            curve.special.iter().map(special).collect::<Vec<_>>(),
        )
        .ended(&curve.ended)
        .units()
        .put("work", curve.work)
}

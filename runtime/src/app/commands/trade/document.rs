//! A trade as JSON.

use serde::Serialize;
use serde_json::{Value, json};

use crate::app::document::{Document, value_of};
use crate::field::Kernel;
use crate::model::ModelInfo;
use crate::study::predict::{Prediction, ReleaseLoss};
use crate::study::trade::{Curve, Need, Point, Precision, Trade};
use crate::study::{End, TradeRecord};

/// A trade; for a range, the most demanding end of each kernel, too.
pub(super) fn document<'a>(info: &'a ModelInfo, record: &TradeRecord) -> Document<'a> {
    let worst = Kernel::ALL.into_iter().filter_map(|kernel| {
        let (end, need) = record.need(kernel)?;
        Some(json!({ "kernel": kernel.name(), "end": end, "need": answer(&need, needed) }))
    });
    let missing = (record.missing > 0).then(|| json!({ "missing": record.missing }));
    let document = Document::new(info).put("model", info.command);
    let document = match &record.along {
        Some(along) => document.range("along", along),
        None => document.put("along", Value::Null),
    };
    document
        .list("ends", &record.ends, |end| at_end(info, end))
        .list("worst", worst, |worst| worst)
        .maybe("interrupted", missing)
        .units()
}

/// What was found, or why nothing was.
fn answer<T>(found: &Result<T, String>, value: impl Fn(&T) -> Value) -> Value {
    match found {
        Ok(found) => value(found),
        Err(reason) => json!({ "reason": reason }),
    }
}

fn needed(need: &Need) -> Value {
    json!({
        "smoothing": need.smoothing.to_string(),
        "size": need.smoothing.size,
        "size_for_frequency": need.frequency_size,
        "error": need.error,
        "setting": need.setting,
    })
}

fn at_end<'a>(info: &'a ModelInfo, end: &End) -> Document<'a> {
    let trade = &end.trade;
    Document::new(info)
        .parameters(&end.parameters)
        .put("exact", exact(info, trade))
        .list("smoothings", &trade.curves, |one| curve(info, one))
        .list("work_precision", &trade.precision, precision)
}

fn exact<'a>(info: &'a ModelInfo, trade: &Trade) -> Document<'a> {
    let (truth, need) = (&trade.exact, trade.need.as_ref());
    let need = need.map(|found| answer(found, |setting| value_of(setting)));
    Document::new(info)
        .put("period", truth.period)
        .put("frequency", 1.0 / truth.period)
        .states("max_abs", &truth.max_abs)
        .put("period_count", truth.period_count)
        .put("cost", truth.cost)
        .put("need", need)
}

fn curve<'a>(info: &'a ModelInfo, curve: &Curve) -> Document<'a> {
    let fits = curve.refused.is_none().then(|| {
        Document::new(info)
            .put("frequency", curve.frequency)
            .states("max_abs", &curve.max_abs)
    });
    let need = curve.need.as_ref();
    Document::new(info)
        .put("kernel", curve.kernel.name())
        .put("refused", curve.refused.as_ref())
        .list("points", &curve.points, |point| copy(info, curve, point))
        .list(
            "lost",
            &curve.lost,
            |(size, reason)| json!({ "size": size, "reason": reason }),
        )
        .put("fits", fits)
        .put("need", need.map(|found| answer(found, needed)))
}

fn copy<'a>(info: &'a ModelInfo, curve: &Curve, point: &Point) -> Document<'a> {
    let predicted = answer(&point.predicted, |found| predicted(info, found).into());
    Document::new(info)
        .put("smoothing", curve.at(point.size).to_string())
        .put("size", point.size)
        .put("stiffness", point.stiffness)
        .put("e_f", point.frequency.abs())
        .states("e_max_abs", point.max_abs.iter().map(|error| error.abs()))
        .put("signed", signed(info, point.frequency, &point.max_abs))
        .put("predicted", predicted)
        .put("resolution", point.resolution)
        .put("cost", point.cost)
        .put("work", point.found)
}

fn signed<'a>(info: &'a ModelInfo, frequency: f64, max_abs: &[impl Serialize]) -> Document<'a> {
    Document::new(info)
        .put("frequency", frequency)
        .states("max_abs", max_abs)
}

fn predicted<'a>(info: &'a ModelInfo, found: &Prediction) -> Document<'a> {
    Document::new(info)
        .put("signed", signed(info, found.frequency, &found.max_abs))
        .put("leading", found.leading)
        .put("asymptotic", found.doubts.is_empty())
        .put("doubts", &found.doubts)
        .states("cancelling", &found.cancelling)
        .list("releases", &found.releases, release)
}

fn release(loss: &ReleaseLoss) -> Value {
    json!({
        "contact": loss.contact,
        "time": loss.time,
        "acceleration": loss.acceleration,
        "compliance": loss.compliance,
        "offset": loss.offset,
        "delay": loss.delay,
        "layer": loss.layer,
    })
}

fn precision(curve: &Precision) -> Value {
    let failed = curve.failed.iter();
    let failed =
        failed.map(|(tolerance, reason)| json!({ "tolerance": tolerance, "reason": reason }));
    json!({
        "dynamics": curve.dynamics(),
        "points": curve.points,
        "failed": failed.collect::<Vec<_>>(),
    })
}

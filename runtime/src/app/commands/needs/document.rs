//! What a scene needs, as JSON.

use serde_json::{Value, json};

use super::text;
use crate::app::document::Document;
use crate::field::Kernel;
use crate::model::ModelInfo;
use crate::study::trade::Need;
use crate::study::{ContactNeed, Lack, ModesNeed, NeedsRecord, ParameterNeed, Placed, TradeRecord};

pub(super) fn document<'a>(info: &'a ModelInfo, record: &NeedsRecord) -> Document<'a> {
    let document = Document::new(info)
        .put("model", info.command)
        .put("accuracy", record.accuracy);
    let document = match &record.along {
        Some(along) => document.range("along", along),
        None => document.put("along", Value::Null),
    };
    document
        .put("ended", record.ended.as_ref().map(|ended| ended.word()))
        .list("places", &record.places, |one| place(info, one))
        .list("structures", &record.modes, modes)
        .put("together", record.together)
        .list("contacts", &record.contacts, contact)
        .list("parameters", &record.parameters, parameter)
        .put("computed", record.copies.as_ref().map(copies))
        .put("cheapest", record.cheapest())
        .list("lacks", &record.lacks, lack)
        .maybe("interrupted", record.interrupted.then_some(true))
        .units()
}

fn place<'a>(info: &'a ModelInfo, place: &Placed) -> Document<'a> {
    Document::new(info)
        .parameters(&place.parameters)
        .put("period", place.period)
        .put("steps", place.steps)
}

fn modes(need: &ModesNeed) -> Value {
    let scan = need.scan.iter().map(|point| {
        json!({
            "modes": point.modes,
            "flexibility": point.flexibility,
            "error": point.error,
            "steps": point.steps,
        })
    });
    json!({
        "structure": need.structure,
        "kept": need.kept,
        "there": need.there,
        "needed": need.needed,
        "error": need.error,
        "steps": need.steps,
        "beyond": need.beyond,
        "more": need.more,
        "next": need.next,
        "scan": scan.collect::<Vec<_>>(),
    })
}

fn contact(need: &ContactNeed) -> Value {
    let written = need.role.instead();
    json!({
        "contact": need.name,
        "role": need.role.name(),
        "instead": written,
        "error": written.map(|_| 0.0),
        "margin": need.margin,
        "switches": need.switches,
    })
}

fn parameter(need: &ParameterNeed) -> Value {
    json!({
        "parameter": need.name,
        "value": need.value,
        "over": need.over,
        "sensitivity": need.sensitivity.as_ref().ok(),
        "reason": need.sensitivity.as_ref().err(),
        "error": need.error,
        "matters": need.matters,
    })
}

/// The exact system and its copies, each where it is most demanding.
fn copies(record: &TradeRecord) -> Value {
    let exact = record.ends.iter().enumerate().filter_map(|(place, end)| {
        let need = end.trade.need.as_ref()?;
        Some(match need {
            Ok(setting) => json!({ "place": place, "setting": setting }),
            Err(reason) => json!({ "place": place, "reason": reason.to_string() }),
        })
    });
    let copies = Kernel::ALL.into_iter().filter_map(|kernel| {
        let (place, need) = record.need(kernel)?;
        Some(match need {
            Ok(Need {
                smoothing, setting, ..
            }) => json!({
                "kernel": kernel.name(),
                "place": place,
                "smoothing": smoothing.to_string(),
                "setting": setting,
            }),
            Err(reason) => json!({
                "kernel": kernel.name(),
                "place": place,
                "reason": reason.to_string(),
            }),
        })
    });
    json!({ "exact": exact.collect::<Vec<_>>(), "copies": copies.collect::<Vec<_>>() })
}

fn lack(lack: &Lack) -> Value {
    let says = text::lack(lack);
    match lack {
        Lack::Press { force, value, .. } => {
            json!({ "kind": "press", "name": force, "value": value, "says": says })
        }
        Lack::Modes {
            structure, error, ..
        } => json!({ "kind": "modes", "name": structure, "value": error, "says": says }),
    }
}

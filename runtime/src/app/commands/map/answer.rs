//! A map in all forms.

use std::collections::BTreeMap;

use super::picture::picture;
use crate::app::answer::Answer;
use crate::app::document::Document;
use crate::app::spreadsheet::Columns;
use crate::app::text::{brief, followed, heading, line, number, states, table, timed};
use crate::model::ModelInfo;
use crate::study::{Attractor, Case, Cell, MapRecord};

/// Digits shown of values.
const DIGITS: usize = 6;
/// Kinds that are shown.
const SHOWN: usize = 16;

pub(super) fn answer<'a>(
    info: &'a ModelInfo,
    case: &'a Case,
    record: &'a MapRecord,
    question: &'a str,
) -> Answer<'a> {
    Answer::new(
        "map",
        move || describe(info, case, record, question),
        move || document(info, case, record, question),
    )
    .figure("map", move || picture(info, record, question))
    .sheet("map", move || columns(info, record).sheet(&record.nodes))
}

type Node = ([f64; 2], Cell);

fn describe(info: &ModelInfo, case: &Case, record: &MapRecord, question: &str) -> String {
    let [across, up] = record.grid.along.map(|along| followed(info, &along));
    let [n, m] = record.grid.values;
    let what = format!("`{question}` at {n} values of {across} and {m} of {up}");
    let mut kinds: BTreeMap<&str, Vec<&Node>> = BTreeMap::new();
    for node in &record.nodes {
        kinds.entry(&node.1.kind).or_default().push(node);
    }
    let mut kinds: Vec<_> = kinds.into_iter().collect();
    kinds.sort_by_key(|(_, nodes)| std::cmp::Reverse(nodes.len()));
    let head = ["", "nodes", "from", "to", "for instance at"].map(str::to_owned);
    let rest = kinds.len().saturating_sub(SHOWN);
    let rows = kinds.iter().take(SHOWN).map(|(kind, nodes)| {
        let values = || nodes.iter().filter_map(|(_, cell)| cell.value);
        let [low, high] = [
            values().fold(f64::INFINITY, f64::min),
            values().fold(f64::NEG_INFINITY, f64::max),
        ];
        let told = |value: f64| {
            if low > high {
                String::new()
            } else {
                number(value, DIGITS)
            }
        };
        let place = nodes[nodes.len() / 2]
            .0
            .map(|value| number(value, DIGITS))
            .join(", ");
        line([
            brief(kind),
            nodes.len().to_string(),
            told(low),
            told(high),
            place,
        ])
    });
    let reason = record
        .nodes
        .iter()
        .find_map(|(_, cell)| cell.reason.as_ref());
    let reason = reason.map_or(String::new(), |reason| {
        format!("\n  for instance: {reason}\n")
    });
    let more = (rest > 0).then(|| format!("  and {rest} more kinds\n"));
    let kinds = table(&(line(head) + &rows.collect::<String>()));
    heading(info, case, &what) + &kinds + &more.unwrap_or_default() + &reason
}

fn document<'a>(
    info: &'a ModelInfo,
    case: &Case,
    record: &MapRecord,
    question: &str,
) -> Document<'a> {
    let node = |(place, cell): &Node| {
        let motion = cell.motion.as_ref();
        Document::new(info)
            .put("at", place)
            .put("kind", &cell.kind)
            .put("value", cell.value)
            .maybe("period", motion.and_then(|one| one.period))
            .maybe("stability", motion.and_then(|one| one.stability))
            .maybe("reason", cell.reason.as_ref())
    };
    let missing = (record.missing > 0).then(|| serde_json::json!({ "missing": record.missing }));
    Document::case(info, case)
        .put("question", question)
        .range("along", &record.grid.along[0])
        .range("and", &record.grid.along[1])
        .put("values", record.grid.values)
        .list("nodes", &record.nodes, node)
        .maybe("interrupted", missing)
        .units()
}

fn columns<'a>(info: &'a ModelInfo, record: &MapRecord) -> Columns<'a, Node> {
    let heads = record.grid.along.map(|along| followed(info, &along));
    let of = |node: &Node, read: fn(&Attractor) -> Option<f64>| read(node.1.motion.as_deref()?);
    let columns = Columns::new()
        .numbers(heads, |node: &Node, k| node.0.get(k).copied())
        .column("kind", |node: &Node| node.1.kind.clone())
        .number("value", |node: &Node| node.1.value)
        .column("reason", |node: &Node| {
            node.1.reason.clone().unwrap_or_default()
        });
    if record.nodes.iter().all(|node| node.1.motion.is_none()) {
        return columns;
    }
    let stability = |node: &Node| Some(node.1.motion.as_ref()?.stability?.name());
    columns
        .number(timed(info, "period", "s"), move |node| {
            of(node, |one| one.period)
        })
        .column("stability", move |node| stability(node).unwrap_or_default())
        .number("error", move |node| of(node, |one| one.error))
        .numbers(states(info, ""), |node, j| {
            node.1.motion.as_ref()?.state.get(j).copied()
        })
        .numbers(states(info, "min_"), |node, j| {
            node.1.motion.as_ref()?.min.get(j).copied()
        })
        .numbers(states(info, "max_"), |node, j| {
            node.1.motion.as_ref()?.max.get(j).copied()
        })
}

//! Motions with their shares in all forms.

use super::drawn::drawn;
use super::{branches, picture, saddles};
use crate::app::answer::Answer;
use crate::app::document::Document;
use crate::app::spreadsheet::{Columns, Holds, Spreadsheet, full, headed, optional};
use crate::app::text::{
    brief, digits, followed, heading, line, number, short, states, table, timed,
};
use crate::model::ModelInfo;
use crate::study::{Attractor, AttractorsRecord, Case, Class, FollowedRecord, Found, Survey};

pub(super) fn answer<'a>(
    info: &'a ModelInfo,
    case: &'a Case,
    found: (&'a AttractorsRecord, Option<&'a FollowedRecord>),
    shown: [usize; 2],
) -> Answer<'a> {
    let record = found.0;
    let followed = record.along.as_ref().zip(found.1);
    let more = move || followed.map(|(along, followed)| branches::text(info, along, followed));
    let answer = Answer::new(
        "attractors",
        move || describe(info, case, record) + &more().unwrap_or_default(),
        move || document(info, case, found),
    )
    .figure("attractors", move || picture::picture(info, found, shown))
    .sheet("attractors", move || motions(info, record))
    .sheet("starts", move || starts(info, record));
    match followed {
        Some((along, followed)) => branches::sheets(answer, (info, case), along, followed),
        None => answer,
    }
}

fn describe(info: &ModelInfo, case: &Case, record: &AttractorsRecord) -> String {
    let what = format!(
        "on what {} starts settle in {}",
        record.sampling.starts,
        within(info, record)
    );
    let along = record.along.map(|along| followed(info, &along));
    let area = record.sampling.areas.then(|| "area".to_owned());
    let period = timed(info, "period", "s");
    let columns = ["motion", "word", &period, "stability", "drawn in by"].map(str::to_owned);
    let shares = ["share", "95 %"].map(str::to_owned).into_iter().chain(area);
    let states = info.states.iter().map(|state| state.name.to_owned());
    let head = along.into_iter().chain(shares).chain(columns).chain(states);
    let mut lines = line(head);
    for survey in &record.surveys {
        for found in &survey.found {
            lines += &line(
                survey
                    .r
                    .map(|r| number(r, 6))
                    .into_iter()
                    .chain(cells(found)),
            );
        }
    }
    heading(info, case, &what) + &table(&lines) + &saddles::text(info, record) + &remarks(record)
}

fn within(info: &ModelInfo, record: &AttractorsRecord) -> String {
    let side = |side: &crate::study::Side| {
        let name = info.states.get(side.state).map_or("", |state| state.name);
        format!("{name} = {}..{}", short(side.low), short(side.high))
    };
    record
        .sampling
        .region
        .sides
        .iter()
        .map(side)
        .collect::<Vec<_>>()
        .join(", ")
}

fn cells(found: &Found) -> impl Iterator<Item = String> {
    let Found {
        attractor,
        share,
        interval: [low, high],
        area,
        ..
    } = found;
    let shown = digits(attractor.error.unwrap_or(1e-9));
    let shares = [format!("{share:.4}"), format!("{low:.4}..{high:.4}")];
    let area = area.map(|[area, error]| format!("{area:.6} ± {}", number(error, 1)));
    let columns = [
        attractor.class.to_string(),
        brief(attractor.word.as_deref().unwrap_or_default()),
        attractor
            .period
            .map_or_else(String::new, |value| number(value, shown)),
        attractor.stability.map_or("", |one| one.name()).to_owned(),
        drawn(attractor),
    ];
    let state = attractor
        .state
        .iter()
        .map(move |y| number(*y, shown.min(9)));
    let state = state.filter(|_| has_place(attractor));
    shares.into_iter().chain(area).chain(columns).chain(state)
}

/// Whether the state of a motion lies on it.
const fn has_place(found: &Attractor) -> bool {
    matches!(
        found.class,
        Class::Equilibrium | Class::Sticking | Class::Orbit | Class::Running
    )
}

/// What has no more to be said of it than a reason.
fn remarks(record: &AttractorsRecord) -> String {
    let all = record.surveys.iter().flat_map(|survey| &survey.found);
    let mut said: Vec<String> = all
        .filter_map(|found| {
            let reason = found.attractor.reason.as_ref()?;
            Some(format!(
                "\n  {}, for instance: {reason}\n",
                found.attractor.class
            ))
        })
        .collect();
    said.dedup();
    said.truncate(4);
    said.concat()
}

fn document<'a>(
    info: &'a ModelInfo,
    case: &Case,
    (record, followed): (&AttractorsRecord, Option<&FollowedRecord>),
) -> Document<'a> {
    let side = |side: &crate::study::Side| {
        let name = info.states.get(side.state).map_or("", |state| state.name);
        serde_json::json!({ "state": name, "from": side.low, "to": side.high })
    };
    let survey = |survey: &Survey| {
        Document::new(info)
            .maybe("r", survey.r)
            .list("motions", &survey.found, |found| motion(info, found))
            .list("edges", &survey.edges, |edge| {
                let between = edge.between.map(|of| of + 1);
                kind(info, &edge.saddle).put("between", between)
            })
            .list("further", &survey.further, |one| kind(info, one))
    };
    let missing = (record.missing > 0).then(|| serde_json::json!({ "missing": record.missing }));
    let document = Document::case(info, case)
        .list("box", &record.sampling.region.sides, side)
        .put("starts", record.sampling.starts);
    let document = match &record.along {
        Some(along) => document.range("along", along),
        None => document,
    };
    let document = document.list("surveys", &record.surveys, survey);
    let document = match followed {
        Some(followed) => branches::documents(document, info, followed),
        None => document,
    };
    document.maybe("interrupted", missing).units()
}

fn motion<'a>(info: &'a ModelInfo, found: &Found) -> Document<'a> {
    kind(info, &found.attractor)
        .put("count", found.count)
        .put("share", found.share)
        .put("interval", found.interval)
        .maybe("area", found.area)
}

fn kind<'a>(info: &'a ModelInfo, one: &Attractor) -> Document<'a> {
    Document::new(info)
        .put("motion", one.class)
        .maybe("word", one.word.as_ref())
        .maybe("period", one.period)
        .states("state", &one.state)
        .states("min", &one.min)
        .states("max", &one.max)
        .maybe("stability", one.stability)
        .maybe_states("shift", one.shift.as_ref())
        .put("multipliers", &one.multipliers)
        .maybe("exponent", one.exponent)
        .maybe("error", one.error)
        .maybe("reason", one.reason.as_ref())
}

/// The motions, each with the value at which it was found.
fn motions(info: &ModelInfo, record: &AttractorsRecord) -> Spreadsheet {
    let along = record.along.map(|along| followed(info, &along));
    let columns = |r: Option<f64>, number: usize| {
        Columns::new()
            .numbers(along.clone(), move |_: &Found, _| r)
            .count("number", move |_| number)
            .column("motion", |found: &Found| found.attractor.class.name())
            .column("word", |found| {
                found.attractor.word.clone().unwrap_or_default()
            })
            .count("count", |found| found.count)
            .number("share", |found| found.share)
            .number("share_low", |found| found.interval[0])
            .number("share_high", |found| found.interval[1])
            .number("area", |found| Some(found.area?[0]))
            .number("area_error", |found| Some(found.area?[1]))
            .number(timed(info, "period", "s"), |found| found.attractor.period)
            .column("stability", |found| {
                found.attractor.stability.map_or("", |one| one.name())
            })
            .number("error", |found| found.attractor.error)
            .numbers(states(info, ""), |found, j| {
                found.attractor.state.get(j).copied()
            })
            .numbers(states(info, "min_"), |found, j| {
                found.attractor.min.get(j).copied()
            })
            .numbers(states(info, "max_"), |found, j| {
                found.attractor.max.get(j).copied()
            })
    };
    let rows = record.surveys.iter().flat_map(|survey| {
        let found = survey.found.iter().zip(1..);
        found.map(move |(found, number)| columns(survey.r, number).row(found))
    });
    headed(columns(None, 0).head(), rows.collect::<Vec<_>>())
}

/// The starts, each with the number of its motion.
fn starts(info: &ModelInfo, record: &AttractorsRecord) -> Spreadsheet {
    let along = record.along.map(|along| followed(info, &along));
    let numbers = along.into_iter().chain(states(info, ""));
    let numbers = numbers.map(|name| Holds::Numbers.under(name));
    let head = numbers.chain([Holds::Counts.under("number")]);
    let rows = record.surveys.iter().flat_map(|survey| {
        survey.starts.iter().map(move |(start, of)| {
            let r = survey.r.map(|r| optional(Some(r)));
            let states = start.iter().map(full);
            r.into_iter()
                .chain(states)
                .chain([(of + 1).to_string()])
                .collect()
        })
    });
    headed(head.collect(), rows)
}

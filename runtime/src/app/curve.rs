//! `branch --and`: a special point followed in two parameters.

use clap::ArgMatches;

use super::App;
use super::branch::{self, Rows};
use super::failure::Failure;
use super::json;
use super::options::{Request, range, text};
use super::orbit::work;
use super::passages::Passages;
use super::picture;
use super::progress::Progress;
use super::resume::Question;
use super::spreadsheet::{Spreadsheet, full, optional};
use super::text::{followed, label, number, parameters, table, timed};
use super::words::{assignment, number as numeral};
use crate::field::Design;
use crate::model::ModelInfo;
use crate::study::{
    Along, Case, CurveFinding, CurvePointRecord, CurveRecord, CurveScope, StudyError,
};

const DIGITS: usize = 10;

/// Whether a curve is asked for; options that make sense only with one, or without, are refused.
pub(super) fn wanted(options: &ArgMatches) -> Result<bool, Failure> {
    let and = text(options, "and").is_some();
    if let (false, Some(of)) = (and, text(options, "of")) {
        return Err(Failure::usage(format!(
            "`--of {of}` names the point to be followed in two parameters, but no second one is there: add `--and NAME=C..D`"
        )));
    }
    for other in ["switch", "from"] {
        if let (true, Some(word)) = (and, text(options, other)) {
            return Err(Failure::usage(format!(
                "`--and` follows one special point and no branches: `--{other} {word}` has no meaning beside it"
            )));
        }
    }
    Ok(and)
}

/// Follows the curve and answers.
pub(super) fn perform(
    app: &App,
    request: Request<'_>,
    options: &ArgMatches,
) -> Result<(), Failure> {
    let Request {
        entry,
        case,
        output,
    } = request;
    let info = entry.info();
    let (case, scope) = asked(info, options, case)?;
    let question = Question::new(app.version, info, &case)
        .exactly("`--and`", &scope.and)
        .exactly("`--of`", &scope.of);
    let mut passages = Passages::open(&output, options, "curve", &question)?;
    let progress = Progress::along(&output);
    let mut journal = output.journal("curve");
    let ranges = [case.along.unwrap_or(scope.and), scope.and];
    let mut rows = Rows::new(&output, info, &case);
    let mut watch = |finding: CurveFinding<'_>| match finding {
        CurveFinding::Orbit(orbit) => rows.add(orbit, &progress),
        CurveFinding::Point(point) => {
            journal.add(|| sheet(info, &ranges, std::slice::from_ref(point)));
            let message = format!("{} = {}", scope.and.name(info), number(point.q, 6));
            progress.reach(scope.and.share(point.q), message)
        }
    };
    let system = passages.recorded(entry);
    let curve = system.curve(&case, &scope, &mut watch);
    let curve = match curve {
        Ok(curve) => curve,
        Err(StudyError::Interrupted(branch)) => {
            drop(progress);
            return branch::deliver(&output, info, &case, &branch);
        }
        Err(error) => return Err(Failure::of(&error, info)),
    };
    drop(progress);
    let kept = branch::keep(&output, info, &case, &curve.branch);
    let drawn = output.draw([("curve", picture::curve(info, &curve))]);
    output.deliver(
        "curve",
        &describe(info, &case, &curve),
        &json::CurveDocument::new(info, &case, &curve),
        &[(
            "curve",
            sheet(info, &[curve.along, curve.and], &curve.points),
        )],
    )?;
    drawn.and(kept)?;
    if !curve.ended.is_interrupted() {
        passages.discard();
    }
    let found = format!("{} points were found", curve.points.len());
    output.close("curve", &curve.ended, &found)
}

/// The case where the curve begins, and what is followed.
fn asked(
    info: &ModelInfo,
    options: &ArgMatches,
    mut case: Case,
) -> Result<(Case, CurveScope), Failure> {
    let word = text(options, "and").unwrap_or_default();
    let and = range(info, "--and", word)?;
    let name = and.name(info);
    if case.along.is_some_and(|along| along.design == and.design) {
        return Err(Failure::usage(format!(
            "`--and {word}` follows what `--along` follows already: name another parameter than `{name}`"
        )));
    }
    if and.design == Design::Smoothing && case.smoothing().is_none() {
        return Err(Failure::usage(format!(
            "`--and {word}` follows the size of a smoothing: name its kernel, for instance `--smooth arctan:{:e}`",
            and.from
        )));
    }
    agrees(options, &and, name)?;
    let along = case.along.replace(and);
    case = case.at(and.from);
    case.along = along;
    let of = text(options, "of").map(|label| label.trim().to_uppercase());
    Ok((case, CurveScope { and, of }))
}

/// A `--set` of the second parameter must give its beginning.
fn agrees(options: &ArgMatches, and: &Along, name: &str) -> Result<(), Failure> {
    for word in options.get_many::<String>("set").into_iter().flatten() {
        let (set, value) = assignment("--set", word)?;
        if set == name && numeral(&format!("--set {word}"), value)? != and.from {
            return Err(Failure::usage(format!(
                "`--set {word}` contradicts `--and {name}={}..{}`, which begins at {name} = {}",
                and.from, and.to, and.from
            )));
        }
    }
    Ok(())
}

fn describe(info: &ModelInfo, case: &Case, curve: &CurveRecord) -> String {
    let names = [&curve.along, &curve.and].map(|range| range.name(info));
    let mut text = format!(
        "{}, {}: {} points ({}) in {} and {}\n  {}\n\n",
        info.command,
        case.dynamics,
        curve.kind,
        curve.of,
        names[0],
        names[1],
        parameters(info, case)
    );
    let axes = || [&curve.along, &curve.and].map(|range| followed(info, range));
    let mut rows = vec![[axes().to_vec(), vec![timed(info, "period", "s")]].concat()];
    rows.extend(curve.points.iter().map(|point| {
        let values = [point.p, point.q, point.period];
        values.map(|value| number(value, DIGITS)).to_vec()
    }));
    text.push_str(&table(&rows));
    if !curve.special.is_empty() {
        let [p, q] = axes();
        let mut rows = vec![vec!["special".to_owned(), "kind".to_owned(), p, q]];
        rows.extend(curve.special.iter().map(|one| {
            let place = [one.point.p, one.point.q].map(|value| number(value, DIGITS));
            let words = [one.label.clone(), one.kind.to_owned()];
            words.into_iter().chain(place).collect()
        }));
        text.push_str(&format!("\n{}", table(&rows)));
    }
    text.push_str(&format!("\n  {}\n", work(&curve.work)));
    text
}

/// One row for each point.
fn sheet(info: &ModelInfo, ranges: &[Along; 2], points: &[CurvePointRecord]) -> Spreadsheet {
    let mut head: Vec<String> = ranges.iter().map(|range| followed(info, range)).collect();
    head.push(timed(info, "period", "s"));
    let states = info.states.iter();
    head.extend(states.map(|state| label(state.name, state.unit)));
    let count = info.states.len().saturating_sub(1);
    for i in 1..=count {
        head.extend(["re", "im"].map(|part| format!("multiplier_{i}_{part}")));
    }
    head.extend(["residual", "test"].map(str::to_owned));
    let row = |point: &CurvePointRecord| {
        let values = [point.p, point.q, point.period];
        let mut row: Vec<String> = values.iter().chain(&point.state).map(full).collect();
        for i in 0..count {
            let multiplier = point.multipliers.get(i);
            row.push(optional(multiplier.map(|m| m.re)));
            row.push(optional(multiplier.map(|m| m.im)));
        }
        row.extend([full(&point.residual), full(&point.test)]);
        row
    };
    Spreadsheet::of(
        std::iter::once(head)
            .chain(points.iter().map(row))
            .collect(),
    )
}

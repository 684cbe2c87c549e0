//! `branch --and`: a special point followed in two parameters.

mod arguments;
mod document;
mod picture;
mod sheet;
mod text;

use super::branch::{self, Rows};
use crate::app::App;
use crate::app::failure::Failure;
use crate::app::passages::Passages;
use crate::app::progress::Progress;
use crate::app::request::{Request, agrees, along, kernel_missing};
use crate::app::resume::Question;
use crate::app::spreadsheet::Spreadsheet;
use crate::app::text::number;
use crate::app::values::{Assignment, Range};
use crate::field::Design;
use crate::model::ModelInfo;
use crate::study::{Case, CurveFinding, CurveScope, StudyError};
pub(in crate::app) use arguments::Arguments;

/// The second range, if a curve is asked for; options that make sense only with one, or without, are refused.
pub(super) fn wanted(asked: &branch::Arguments) -> Result<Option<&Range>, Failure> {
    let Some(and) = &asked.curve.and else {
        return match &asked.curve.of {
            Some(of) => Err(Failure::usage(format!(
                "`--of {of}` names the point to be followed in two parameters, but no second one is there: add `--and NAME=C..D`"
            ))),
            None => Ok(None),
        };
    };
    let switch = asked.switch.map(|switch| ("switch", switch.name()));
    let from = asked.from.as_ref().map(|from| ("from", from.word.as_str()));
    match switch.or(from) {
        Some((other, word)) => Err(Failure::usage(format!(
            "`--and` follows one special point and no branches: `--{other} {word}` has no meaning beside it"
        ))),
        None => Ok(Some(and)),
    }
}

/// Follows the curve and answers.
pub(super) fn perform(
    app: &App,
    request: Request<'_>,
    and: &Range,
    arguments: &branch::Arguments,
) -> Result<(), Failure> {
    let Request {
        entry,
        info,
        case,
        output,
    } = request;
    let (case, scope) = asked(info, and, arguments, case)?;
    let question = Question::new(app.version, info, &case)
        .exactly("`--and`", &scope.and)
        .exactly("`--of`", &scope.of);
    let resume = arguments.resume.resume;
    let mut passages = Passages::open(&output, resume, "curve", &question)?;
    let progress = Progress::along(&output);
    let ranges = [&case.along.unwrap_or(scope.and), &scope.and];
    let mut journal = output.journal("curve", sheet::head(info, ranges));
    let mut rows = Rows::new(&output, info, &case);
    let mut watch = |finding: CurveFinding<'_>| match finding {
        CurveFinding::Orbit(orbit) => rows.add(orbit, &progress),
        CurveFinding::Point(point) => {
            journal.add([sheet::row(point)]);
            let message = format!("{} = {}", scope.and.name(info), number(point.q, 6));
            progress.reach(scope.and.share(point.q), message)
        }
    };
    let curve = passages.through(|tape| entry.curve(&case, &scope, tape, &mut watch));
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
    let drawn = output.draw([("curve", picture::picture(info, &curve))]);
    let rows = curve.points.iter().map(sheet::row);
    output.deliver(
        "curve",
        &text::describe(info, &case, &curve),
        &document::document(info, &case, &curve),
        &[("curve", Spreadsheet::new(sheet::head(info, ranges), rows))],
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
    range: &Range,
    arguments: &branch::Arguments,
    mut case: Case,
) -> Result<(Case, CurveScope), Failure> {
    let word = &range.word;
    let and = along(info, "--and", range)?;
    let name = and.name(info);
    if case.along.is_some_and(|along| along.design == and.design) {
        return Err(Failure::usage(format!(
            "`--and {word}` follows what `--along` follows already: name another parameter than `{name}`"
        )));
    }
    if and.design == Design::Smoothing && case.smoothing().is_none() {
        return Err(kernel_missing(&format!("--and {word}"), &and));
    }
    for Assignment {
        word,
        name: set,
        value,
    } in &arguments.subject.settings.set
    {
        if set == name {
            agrees(word, *value, "--and", name, and)?;
        }
    }
    let along = case.along.replace(and);
    case = case.at(and.from);
    case.along = along;
    let of = arguments.curve.of.as_ref();
    let of = of.map(|label| label.trim().to_uppercase());
    Ok((case, CurveScope { and, of }))
}

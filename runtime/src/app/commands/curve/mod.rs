//! `branch --and`: a special point followed in two parameters.

mod answer;

use super::branch;
use crate::app::failure::{Failure, refuse};
use crate::app::offer::App;
use crate::app::passages::Passages;
use crate::app::progress::{Progress, Trail};
use crate::app::question::Question;
use crate::app::request::{agrees, along, kernel_missing, request};
use crate::app::values::{Assignment, Range};
use crate::field::Design;
use crate::model::ModelInfo;
use crate::study::{Case, CurveFinding, CurveScope, Curved};
use answer::{answer, columns};

/// The second range, if a curve is asked for; options that make sense only with one, or without, are refused.
pub(in crate::app) fn wanted(asked: &branch::Arguments) -> Result<Option<&Range>, Failure> {
    let Some(and) = &asked.curve.and else {
        return match &asked.curve.of {
            Some(of) => refuse!(
                "`--of {of}` names the point to be followed in two parameters, but no second one is there: add `--and NAME=C..D`"
            ),
            None => Ok(None),
        };
    };
    match asked.switch {
        Some((word, _)) => refuse!(
            "`--and` follows one special point and no branches: `--switch {word}` has no meaning beside it"
        ),
        None => Ok(Some(and)),
    }
}

/// Follows the curve and answers.
pub(in crate::app) fn perform(
    app: &App,
    arguments: &branch::Arguments,
    and: &Range,
) -> Result<(), Failure> {
    let range = arguments.range()?;
    let mut asked = request(app, &arguments.subject, Some(range), arguments.guess.period)?;
    let info = asked.info;
    let (case, scope) = plane(info, and, arguments, asked.case)?;
    asked.case = arguments.of(info, case)?;
    let shown = arguments.shown(info)?;
    let progress = Progress::along(&asked.output, branch::FIRST);
    let question = Question::new(app.version, info, &asked.case)
        .exactly("`--and`", &scope.and)
        .exactly("`--of`", &scope.of);
    let mut passages = Passages::open(&asked.output, &arguments.resume, "curve", &question)?;
    let columns = columns(info, [&asked.along()?, &scope.and]);
    let mut orbits = branch::trail(&asked, &progress)?;
    let mut points = Trail::new(&asked, scope.and, "curve", columns, &progress);
    let mut watch = |finding: CurveFinding<'_>| match finding {
        CurveFinding::Orbit(orbit) => orbits.reach(orbit.r, orbit),
        CurveFinding::Point(point) => points.reach(Some(point.q), point),
    };
    let curve = passages
        .recorded(&asked.entry.telling(progress.news(branch::FIRST)))
        .curve_watched(&asked.case, &scope, &mut watch);
    drop(progress);
    let curve = match curve {
        Ok(Curved::Followed(curve)) => curve,
        Ok(Curved::Interrupted(branch)) => return branch::deliver(&asked, &branch, &shown),
        Err(error) => return Err(asked.failed(error)),
    };
    let kept = asked
        .output
        .keep(&branch::answer(&asked, &curve.branch, &shown));
    asked.output.deliver(&answer(info, &asked.case, &curve))?;
    kept?;
    if !curve.ended.is_interrupted() {
        passages.discard();
    }
    let found = format!("{} points were found", curve.points.len());
    asked.output.close("curve", &curve.ended, &found)
}

/// The case where the curve begins, and what is followed.
fn plane(
    info: &ModelInfo,
    range: &Range,
    arguments: &branch::Arguments,
    mut case: Case,
) -> Result<(Case, CurveScope), Failure> {
    let word = &range.word;
    let and = along(info, "--and", range)?;
    let name = and.name(info);
    if case.along.is_some_and(|along| along.design == and.design) {
        return refuse!(
            "`--and {word}` follows what `--along` follows already: name another parameter than `{name}`"
        );
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

//! `branch --and`, `equilibria --and`: a special point followed in two parameters.

mod answer;
mod equilibria;

use std::ops::ControlFlow;

use super::branch;
use crate::app::arguments::{Curve, Subject};
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
use answer::{Of, answer, columns};
pub(in crate::app) use equilibria::{of_equilibria, wanted_of_equilibria};

/// The second range, if a curve is asked for: what makes sense only without one is refused.
pub(in crate::app) fn wanted(asked: &branch::Arguments) -> Result<Option<&Range>, Failure> {
    let and = second(&asked.curve)?;
    match (and, asked.switch) {
        (Some(_), Some((word, _))) => refuse!(
            "`--and` follows one special point and no branches: `--switch {word}` has no meaning beside it"
        ),
        _ => Ok(and),
    }
}

/// The second range; an option that makes sense only with one is refused.
fn second(asked: &Curve) -> Result<Option<&Range>, Failure> {
    match (&asked.and, &asked.of) {
        (None, Some(of)) => refuse!(
            "`--of {of}` names the point to be followed in two parameters, but no second one is there: add `--and NAME=C..D`"
        ),
        (and, _) => Ok(and.as_ref()),
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
    let (case, scope) = plane(
        info,
        and,
        (&arguments.subject, &arguments.curve),
        asked.case,
    )?;
    asked.case = arguments.of(info, case)?;
    let shown = arguments.shown(info)?;
    let progress = Progress::along(&asked.output, branch::FIRST);
    let question = Question::new(app.version, info, &asked.case)
        .exactly("`--and`", &scope.and)
        .exactly("`--of`", &scope.of);
    let mut passages = Passages::open(&asked.output, &arguments.resume, "curve", &question)?;
    let columns = columns(info, [&asked.along()?, &scope.and], Of::Orbits);
    let mut orbits = branch::trail(&asked, &progress)?;
    let mut points = Trail::new(&asked, scope.and, "curve", columns, &progress);
    let mut watch = |finding: CurveFinding<'_>| match finding {
        CurveFinding::Orbit(orbit) => orbits.reach(orbit.r, orbit),
        CurveFinding::Equilibrium(_) => ControlFlow::Continue(()),
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
    asked
        .output
        .deliver(&answer(info, &asked.case, &curve, Of::Orbits))?;
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
    (subject, curve): (&Subject, &Curve),
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
    } in &subject.settings.set
    {
        if set == name {
            agrees(word, *value, "--and", name, and)?;
        }
    }
    let along = case.along.replace(and);
    case = case.at(and.from);
    case.along = along;
    let of = curve.of.as_ref();
    let of = of.map(|label| label.trim().to_uppercase());
    Ok((case, CurveScope { and, of }))
}

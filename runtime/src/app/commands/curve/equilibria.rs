//! `equilibria --and`: a fold or a Hopf point of equilibria followed in two parameters.

use std::ops::ControlFlow;

use super::answer::{Of, answer, columns};
use super::{plane, second};
use crate::app::commands::equilibria;
use crate::app::failure::{Failure, refuse};
use crate::app::offer::App;
use crate::app::progress::{Progress, Trail};
use crate::app::request::request;
use crate::app::values::Range;
use crate::study::{CurveFinding, Curved};

/// The second range, if a curve is asked for: what makes sense only without one is refused.
pub(in crate::app) fn wanted_of_equilibria(
    asked: &equilibria::Arguments,
) -> Result<Option<&Range>, Failure> {
    let and = second(&asked.curve)?;
    match (and, asked.certify) {
        (Some(_), true) => refuse!(
            "`--certify` proves the equilibria at one value of every parameter: it has no meaning beside `--and`"
        ),
        (Some(_), _) if asked.way.along.is_none() => refuse!(
            "`--and` follows a special point in a second parameter: `--along NAME=A..B` names the first one"
        ),
        _ => Ok(and),
    }
}

/// Follows the curve and answers.
pub(in crate::app) fn of_equilibria(
    app: &App,
    arguments: &equilibria::Arguments,
    and: &Range,
) -> Result<(), Failure> {
    arguments.resume.refuse()?;
    let range = arguments.way.along.as_ref();
    let mut asked = request(app, &arguments.subject, range, None)?;
    let info = asked.info;
    let given = (&arguments.subject, &arguments.curve);
    let (case, scope) = plane(info, and, given, asked.case)?;
    asked.case = case;
    let along = asked.along()?;
    let progress = Progress::along(&asked.output, equilibria::FIRST);
    let mut branch = equilibria::trail(&asked, along, &progress);
    let columns = columns(info, [&along, &scope.and], Of::Equilibria);
    let mut points = Trail::new(&asked, scope.and, "curve", columns, &progress);
    let mut watch = |finding: CurveFinding<'_>| match finding {
        CurveFinding::Orbit(_) => ControlFlow::Continue(()),
        CurveFinding::Equilibrium(one) => branch.reach(one.r, one),
        CurveFinding::Point(point) => points.reach(Some(point.q), point),
    };
    let curve = asked
        .entry
        .equilibria_curve_watched(&asked.case, &scope, &mut watch);
    drop(progress);
    let curve = match asked.got(curve)? {
        Curved::Followed(curve) => curve,
        Curved::Interrupted(branch) => return equilibria::deliver(&asked, &branch),
    };
    let (case, output) = (&asked.case, &asked.output);
    let kept = output.keep(&equilibria::branch(info, case, &curve.branch));
    output.deliver(&answer(info, case, &curve, Of::Equilibria))?;
    kept?;
    let found = format!("{} points were found", curve.points.len());
    output.close("curve", &curve.ended, &found)
}

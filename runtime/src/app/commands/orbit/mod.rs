//! `orbit`: a periodic orbit and its stability.

mod certificate;
mod record;

use std::ops::ControlFlow;

use clap::Args;

use super::simulate;
use crate::app::answer::Answer;
use crate::app::arguments::{Period, Subject};
use crate::app::failure::Failure;
use crate::app::harmonics::{self, Harmonics};
use crate::app::offer::App;
use crate::app::output::Output;
use crate::app::progress::Progress;
use crate::app::request::{Request, request};
use crate::app::section::{Cut, with_points};
use crate::app::show::Show;
use crate::app::text::number;
use crate::model::ModelInfo;
use crate::shooting::{Certificate, Uncertified};
use crate::study::{
    Case, CertifiedOrbit, OrbitRecord, Span, StudyError, System, Trajectory, choose,
};
pub(super) use record::{columns, document, largest, point, shown};

/// What is done before anything is found.
const SEARCH: &str = "looking for a periodic orbit";
/// An estimate this many times above the accuracy asked for is worth a word.
const MISSED: f64 = 10.0;

/// Find a periodic orbit and judge its stability
#[derive(Debug, Clone, Args)]
#[command(
    after_help = "A certificate says within which radius of the start a true orbit begins; the orbit is printed without \
                  one, too, and the exit code is 1 then"
)]
pub(in crate::app) struct Arguments {
    #[command(flatten)]
    subject: Subject,
    #[command(flatten)]
    guess: Period,
    #[command(flatten)]
    cut: Cut,
    #[command(flatten)]
    harmonics: Harmonics,
    #[command(flatten)]
    show: Show,
    /// How near a true orbit is, by Newton and Kantorovich: a posteriori, not rigorous
    #[arg(long)]
    certify: bool,
}

pub(in crate::app) fn perform(app: &App, arguments: &Arguments) -> Result<(), Failure> {
    let mut asked = request(app, &arguments.subject, None, arguments.guess.period)?;
    asked.case.harmonics = arguments.harmonics.of(asked.info);
    let (entry, info, case, output) = (asked.entry, asked.info, &asked.case, &asked.output);
    let section = arguments.cut.of(info)?;
    let shown = arguments.show.quantities(info)?;
    let failed = |error| asked.failed(error);
    let progress = Progress::endless(output, SEARCH);
    let entry = &entry.telling(progress.news(SEARCH));
    let (orbit, certificate) = find(entry, case, arguments.certify).map_err(failed)?;
    let from = Case {
        start: Some(orbit.state.clone()),
        modes: orbit.modes.clone(),
        ..case.clone()
    };
    let motion = drawn(&asked, &from, orbit.period)?;
    let reason = reason(arguments, &asked);
    let series = arguments.harmonics.series(entry, case, &orbit);
    let mut answer = Answer::new(
        "orbit",
        || record::describe(info, case, &orbit),
        || document(info, &orbit).put("method", &reason),
    );
    if let Some(series) = &series {
        answer = answer.words(|| harmonics::counted(info, series));
        answer = answer.part("series", || harmonics::counts(info, series));
    }
    if let Some(found) = &certificate {
        answer = answer.words(|| certificate::describe(info, found));
    }
    let span = Span::Period(orbit.period);
    answer = with_points(answer, &asked, &from, section, span)?;
    drop(progress);
    answer = answer.words(|| format!("\n  {reason}\n"));
    if let Some(found) = &certificate {
        answer = answer.part("certificate", || certificate::document(info, found));
    }
    if let Some(motion) = &motion {
        answer = simulate::drawn("orbit", answer, (info, output), motion, &shown);
    }
    doubt(output, case, &orbit);
    coarse(output, info, arguments.subject.accuracy);
    output.deliver(&answer.part("work", || orbit.work))?;
    verdict(certificate.as_ref())
}

/// The orbit once around, if it is drawn.
fn drawn(asked: &Request<'_>, from: &Case, period: f64) -> Result<Option<Trajectory>, Failure> {
    if !asked.output.is_kept() {
        return Ok(None);
    }
    let limits = simulate::limits(&asked.output, u64::MAX);
    let mut watch = |_: &Trajectory| ControlFlow::Continue(());
    let motion = asked.entry.motion_within(from, period, limits, &mut watch);
    asked.got(motion).map(Some)
}

/// The method that was chosen, and why.
fn reason(arguments: &Arguments, asked: &Request<'_>) -> String {
    let (info, case) = (asked.info, &asked.case);
    // `--exact` asks for what would be chosen anyway.
    let wanted = arguments.subject.smooth.as_ref().map(|_| case.dynamics);
    choose(info, wanted, case.accuracy).reason
}

/// The orbit of a case, with its certificate if that is wanted.
fn find(
    entry: &System,
    case: &Case,
    certify: bool,
) -> Result<(OrbitRecord, Option<Result<Certificate, Uncertified>>), StudyError> {
    if !certify {
        return Ok((entry.orbit(case)?, None));
    }
    let CertifiedOrbit { orbit, certificate } = entry.certified_orbit(case)?;
    Ok((orbit, Some(certificate)))
}

/// Says that an orbit is less accurate than asked for, if it is.
fn doubt(output: &Output, case: &Case, orbit: &OrbitRecord) {
    if orbit.error_estimate > MISSED * case.accuracy {
        output.note(format!(
            "note: the estimated error, {}, is larger than the accuracy asked for, {:e}: the orbit hardly attracts, or \
             its numbers are near the end of their digits",
            number(orbit.error_estimate, 2),
            case.accuracy
        ));
    }
}

/// Says which structures have been left with fewer modes than the accuracy that was asked for takes, if any have.
fn coarse(output: &Output, info: &ModelInfo, accuracy: Option<f64>) {
    for structure in info.structures {
        let beyond = structure.share_beyond(structure.kept);
        if accuracy.is_some_and(|accuracy| beyond > accuracy) {
            output.note(format!(
                "note: `{}` keeps {} of {} modes, and what is left out holds a share of {} of the flexibility of its points: \
                 more than the accuracy asked for; `needs` tells what that changes",
                structure.name,
                structure.kept,
                structure.modes.len(),
                number(beyond, 2)
            ));
        }
    }
}

fn verdict(certificate: Option<&Result<Certificate, Uncertified>>) -> Result<(), Failure> {
    match certificate {
        Some(Err(reason)) => Err(Failure::failed(format!(
            "the orbit is not certified: {reason}"
        ))),
        _ => Ok(()),
    }
}

//! `orbit`: a periodic orbit and its stability.

mod certificate;
mod record;

use clap::Args;

use super::simulate;
use crate::app::arguments::{Period, Subject};
use crate::app::failure::Failure;
use crate::app::harmonics::Harmonics;
use crate::app::offer::App;
use crate::app::output::{Answer, Output};
use crate::app::progress::Progress;
use crate::app::request::{Request, request};
use crate::app::section::{Cut, with_points};
use crate::app::text::number;
use crate::shooting::{Certificate, Uncertified};
use crate::study::{Case, CertifiedOrbit, OrbitRecord, Span, StudyError, System, choose};
pub(super) use record::{columns, document, largest, shown};

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
    /// How near a true orbit is, by Newton and Kantorovich: a posteriori, not rigorous
    #[arg(long)]
    certify: bool,
}

pub(in crate::app) fn perform(app: &App, arguments: &Arguments) -> Result<(), Failure> {
    let mut asked = request(app, &arguments.subject, None, arguments.guess.period)?;
    asked.case.harmonics = arguments.harmonics.of(asked.info);
    let (entry, info, case, output) = (asked.entry, asked.info, &asked.case, &asked.output);
    let section = arguments.cut.of(info)?;
    let failed = |error| asked.failed(error);
    let progress = Progress::endless(output, "looking for a periodic orbit");
    let (orbit, certificate) = find(entry, case, arguments.certify).map_err(failed)?;
    let from = Case {
        start: Some(orbit.state.clone()),
        ..case.clone()
    };
    let mut text = record::describe(info, case, &orbit);
    if let Some(found) = &certificate {
        text.push_str(&certificate::describe(info, found));
    }
    let reason = reason(arguments, &asked);
    let document = document(info, &orbit).put("method", &reason);
    let answer = Answer::new("orbit", text, document);
    let span = Span::Period(orbit.period);
    let mut answer = with_points(answer, &asked, &from, section, span)?;
    if output.is_kept() {
        let motion = entry.motion(&from, orbit.period).map_err(failed)?;
        answer = simulate::drawn("orbit", answer, info, &motion);
    }
    drop(progress);
    answer.text.push_str(&format!("\n  {reason}\n"));
    if let Some(found) = &certificate {
        answer = answer.part("certificate", "", certificate::document(info, found));
    }
    doubt(output, case, &orbit);
    output.deliver(answer.part("work", "", orbit.work))?;
    verdict(certificate.as_ref())
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

fn verdict(certificate: Option<&Result<Certificate, Uncertified>>) -> Result<(), Failure> {
    match certificate {
        Some(Err(reason)) => Err(Failure::failed(format!(
            "the orbit is not certified: {reason}"
        ))),
        _ => Ok(()),
    }
}

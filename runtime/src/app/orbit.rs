//! `orbit`: a periodic orbit and its stability.

mod certificate;

use clap::ArgMatches;

use super::App;
use super::failure::Failure;
use super::json;
use super::options::{Request, request, text};
use super::picture;
use super::progress::Progress;
use super::section;
use super::spreadsheet::Spreadsheet;
use super::text::{digits, label, number, parameters, table, time_unit};
use crate::field::Work;
use crate::model::ModelInfo;
use crate::study::{Case, CertifiedOrbit, OrbitRecord, Span, choose};

/// An estimate this many times above the accuracy asked for is worth a word.
const MISSED: f64 = 10.0;

pub(super) fn perform(app: &App, options: &ArgMatches) -> Result<(), Failure> {
    let Request {
        entry,
        case,
        output,
    } = request(app, options)?;
    let info = entry.info();
    let section = section::section(info, options)?;
    let failed = |error| Failure::of(&error, info);
    let progress = Progress::endless(&output, "looking for a periodic orbit");
    let (orbit, certificate) = if options.get_flag("certify") {
        let CertifiedOrbit { orbit, certificate } = entry.certified_orbit(&case).map_err(failed)?;
        (orbit, Some(certificate))
    } else {
        (entry.orbit(&case).map_err(failed)?, None)
    };
    let certificate = certificate.as_ref();
    let mut sheets = Vec::new();
    let from = Case {
        start: Some(orbit.state.clone()),
        ..case.clone()
    };
    let (mut points, mut points_text) = (None, String::new());
    let mut drawn = Ok(());
    if let Some(section) = section {
        let span = Span::Period(orbit.period);
        let found = entry.crossings(&from, section, span).map_err(failed)?;
        points_text = section::describe(info, &section, &found);
        sheets.push(("section", Spreadsheet::crossings(info, &found)));
        points = Some(json::Crossings::new(info, &section, &found));
    }
    if output.out.is_some() {
        let motion = entry.motion(&from, orbit.period).map_err(failed)?;
        sheets.push(("orbit", Spreadsheet::motion(info, &motion)));
        drawn = output.draw([("orbit", picture::motion(info, &motion))]);
    }
    drop(progress);
    // `--exact` asks for what would be chosen anyway.
    let asked = text(options, "smooth").is_some();
    let choice = choose(info, asked.then_some(case.dynamics), case.accuracy);
    let text = [
        describe(info, &case, &orbit),
        certificate.map_or_else(String::new, |found| certificate::describe(info, found)),
        points_text,
        format!("\n  {}\n", choice.reason),
    ]
    .concat();
    let document = json::Orbit::new(info, &orbit)
        .with_method(choice.reason)
        .with_section(points)
        .with_certificate(info, certificate);
    if orbit.error_estimate > MISSED * case.accuracy {
        output.note(format!(
            "note: the estimated error, {}, is larger than the accuracy asked for, {:e}: the orbit hardly attracts, or \
             its numbers are near the end of their digits",
            number(orbit.error_estimate, 2),
            case.accuracy
        ));
    }
    output
        .deliver("orbit", &text, &document, &sheets)
        .and(drawn)?;
    match certificate {
        Some(Err(reason)) => Err(Failure::failed(format!(
            "the orbit is not certified: {reason}"
        ))),
        _ => Ok(()),
    }
}

fn describe(info: &ModelInfo, case: &Case, orbit: &OrbitRecord) -> String {
    let stability = orbit.floquet.stability.name();
    [
        format!(
            "{}, {}: a periodic orbit, {stability}\n",
            info.command, case.dynamics
        ),
        format!("  {}\n\n", parameters(info, case)),
        table(&period(info, orbit)),
        "\n".to_owned(),
        table(&states(info, orbit)),
        "\n".to_owned(),
        table(&multipliers(orbit)),
        "\n".to_owned(),
        table(&quality(info, orbit)),
    ]
    .concat()
}

fn period(info: &ModelInfo, orbit: &OrbitRecord) -> Vec<Vec<String>> {
    let digits = digits(orbit.error_estimate);
    let time = time_unit(info);
    let inverse = if time.is_empty() { "" } else { " 1/s" };
    let mut rows = vec![
        vec!["period".to_owned(), number(orbit.period, digits) + time],
        vec![
            "frequency".to_owned(),
            number(1.0 / orbit.period, digits) + inverse,
        ],
        vec!["crossings".to_owned(), orbit.period_count.to_string()],
    ];
    if let Some(word) = &orbit.word {
        rows.push(vec!["word".to_owned(), word.clone()]);
    }
    rows
}

fn states(info: &ModelInfo, orbit: &OrbitRecord) -> Vec<Vec<String>> {
    let digits = digits(orbit.error_estimate);
    let mut rows = vec![
        ["state", "start", "min", "max", "max abs"]
            .map(str::to_owned)
            .to_vec(),
    ];
    for (j, state) in info.states.iter().enumerate() {
        let largest = orbit.max_abs.get(j).copied().unwrap_or(0.0);
        let show = |value: f64| {
            let rounding = value.abs() <= f64::EPSILON * largest;
            number(if rounding { 0.0 } else { value }, digits)
        };
        let columns = [&orbit.state, &orbit.min, &orbit.max, &orbit.max_abs];
        let mut row = vec![label(state.name, state.unit)];
        row.extend(columns.map(|column| column.get(j).copied().map_or(String::new(), show)));
        rows.push(row);
    }
    rows
}

fn multipliers(orbit: &OrbitRecord) -> Vec<Vec<String>> {
    let mut rows = vec![
        ["multiplier", "ln |multiplier|"]
            .map(str::to_owned)
            .to_vec(),
    ];
    let floquet = &orbit.floquet;
    for (multiplier, log) in floquet.multipliers.iter().zip(&floquet.log_moduli) {
        let value = match multiplier.im {
            0.0 => number(multiplier.re, 8),
            im => format!(
                "{} {} {}i",
                number(multiplier.re, 8),
                sign(im),
                number(im.abs(), 8)
            ),
        };
        let log = log.map_or_else(|| "-".to_owned(), |log| number(log, 8));
        rows.push(vec![value, log]);
    }
    rows
}

fn sign(value: f64) -> char {
    if value < 0.0 { '-' } else { '+' }
}

fn quality(info: &ModelInfo, orbit: &OrbitRecord) -> Vec<Vec<String>> {
    let small = |value| number(value, 2);
    let mut rows = vec![
        vec!["error estimate".to_owned(), small(orbit.error_estimate)],
        vec!["residual".to_owned(), small(orbit.residual)],
    ];
    if info.drive.is_none() {
        let off = small(orbit.floquet.trivial_error);
        rows.push(vec!["trivial multiplier off by".to_owned(), off]);
    }
    rows.push(vec!["work".to_owned(), work(&orbit.work)]);
    rows
}

/// Counted work in one line.
pub(super) fn work(work: &Work) -> String {
    let counts = [
        (work.steps, "steps"),
        (work.rejected, "rejected"),
        (work.evaluations, "evaluations"),
        (work.linearisations, "linearisations"),
        (work.factorisations, "factorisations"),
        (work.events, "events"),
        (work.newton, "Newton iterations"),
    ];
    let told = counts.iter().filter(|(count, _)| *count > 0);
    told.map(|(count, name)| format!("{count} {name}"))
        .collect::<Vec<_>>()
        .join(", ")
}

//! The options that all commands share, as a case.

use clap::ArgMatches;

use super::App;
use super::failure::Failure;
use super::output::Output;
use super::words::{assignment, number, positive, unknown};
use crate::field::{Design, Smoothing};
use crate::model::ModelInfo;
use crate::study::{Along, Case, Dynamics, System};

/// What is asked of which model, and where the answer goes.
pub(super) struct Request<'a> {
    pub(super) entry: &'a System,
    pub(super) case: Case,
    pub(super) output: Output,
}

/// Reads a request; nothing has been computed or written yet.
pub(super) fn request<'a>(app: &'a App, options: &ArgMatches) -> Result<Request<'a>, Failure> {
    resumes(options)?;
    let entry = app.entry(model(app, options)?)?;
    let info = entry.info();
    let along = text(options, "along")
        .map(|word| range(info, "--along", word))
        .transpose()?;
    let mut case = Case::declared(info, dynamics(info, options, along)?);
    case.along = along;
    set(info, options, &mut case)?;
    if let Some(along) = along {
        case = case.at(along.from);
    }
    case.start = text(options, "start")
        .map(|word| start(info, word))
        .transpose()?;
    case.period = text(options, "period")
        .map(|word| positive("--period", word))
        .transpose()?;
    case.accuracy = text(options, "accuracy").map_or(Ok(case.accuracy), accuracy)?;
    entry
        .check(&case)
        .map_err(|error| Failure::of(&error, info))?;
    let output = Output::new(options)?;
    if let Some(size) = superseded(options, along) {
        output.note(format!(
            "note: the smoothing begins at the size {size}, as `--along` says"
        ));
    }
    Ok(Request {
        entry,
        case,
        output,
    })
}

/// Whether `--resume`, if it is there, has a meaning: for a `diagram`, which can `settle`, and for a `branch`, which may
/// have `depth`.
fn resumes(options: &ArgMatches) -> Result<(), Failure> {
    let asked = options.try_get_one::<bool>("resume").ok().flatten() == Some(&true);
    let has = |name| options.try_contains_id(name).is_ok();
    if asked && !has("settle") && !has("depth") {
        return Err(Failure::usage(
            "`--resume` goes on with a `diagram` or a `branch` only, which may take long: leave it out, and this is done anew",
        ));
    }
    Ok(())
}

/// The value of an option that this command may not even have.
pub(super) fn text<'a>(options: &'a ArgMatches, name: &str) -> Option<&'a str> {
    options
        .try_get_one::<String>(name)
        .ok()
        .flatten()
        .map(String::as_str)
}

fn model<'a>(app: &App, options: &'a ArgMatches) -> Result<&'a str, Failure> {
    text(options, "MODEL").ok_or_else(|| {
        let names = app.names().join(", ");
        Failure::usage(format!("no model is named: there are {names}"))
    })
}

/// The place of the parameter of this name.
fn parameter(info: &ModelInfo, name: &str, also: &[&'static str]) -> Result<usize, Failure> {
    let place = info
        .parameters
        .iter()
        .position(|declared| declared.name == name);
    place.ok_or_else(|| {
        if info.states.iter().any(|state| state.name == name) {
            return Failure::usage(format!(
                "`{name}` is a state of `{}`, not a parameter: `--start {name}=...` says where it begins",
                info.command
            ));
        }
        let mut names: Vec<&str> = info.parameters.iter().map(|declared| declared.name).collect();
        names.extend(also);
        Failure::usage(unknown(&format!("`{}` has no parameter", info.command), name, &names))
    })
}

/// A value that the parameter may have.
fn bounded(info: &ModelInfo, index: usize, place: &str, word: &str) -> Result<f64, Failure> {
    let value = number(place, word)?;
    let verdict = info
        .parameters
        .get(index)
        .map_or(Ok(()), |declared| declared.check(value));
    verdict.map_err(|error| Failure::usage(format!("`{place}`: {error}")))?;
    Ok(value)
}

/// Sets parameters as `--set` says.
pub(super) fn set(info: &ModelInfo, options: &ArgMatches, case: &mut Case) -> Result<(), Failure> {
    let mut done = vec![false; case.parameters.len()];
    let words = options.get_many::<String>("set").into_iter().flatten();
    for word in words {
        let (name, value) = assignment("--set", word)?;
        let index = parameter(info, name, &[])?;
        let value = bounded(info, index, &format!("--set {word}"), value)?;
        if std::mem::replace(&mut done[index], true) {
            return Err(Failure::usage(format!(
                "`--set {name}=...` is given more than once"
            )));
        }
        if let Some(along) = case.along
            && along.design == Design::Parameter(index)
            && along.from != value
        {
            return Err(Failure::usage(format!(
                "`--set {word}` contradicts `--along {name}={}..{}`, which begins at {name} = {}",
                along.from, along.to, along.from
            )));
        }
        case.parameters[index] = value;
    }
    Ok(())
}

/// `name=a..b`, the value of this option.
pub(super) fn range(info: &ModelInfo, option: &str, word: &str) -> Result<Along, Failure> {
    let place = format!("{option} {word}");
    let (name, range) = assignment(option, word)?;
    let design = match name {
        "smooth" => Design::Smoothing,
        _ => Design::Parameter(parameter(info, name, &["smooth"])?),
    };
    let ends = range
        .split_once("..")
        .filter(|(_, to)| !to.starts_with('.'));
    let Some((from, to)) = ends else {
        return Err(Failure::usage(format!(
            "`{place}`: `{range}` is no range: write where it begins and ends, for instance `{name}=0.2..0.1`"
        )));
    };
    let end = |word: &str| match design {
        Design::Parameter(index) => bounded(info, index, &place, word),
        Design::Smoothing | Design::None => positive(&place, word),
    };
    let along = Along {
        design,
        from: end(from)?,
        to: end(to)?,
    };
    if along.from == along.to {
        return Err(Failure::usage(format!(
            "`{place}` begins and ends at {}: there is nothing to follow; `orbit` finds a single orbit",
            along.from
        )));
    }
    Ok(along)
}

fn dynamics(
    info: &ModelInfo,
    options: &ArgMatches,
    along: Option<Along>,
) -> Result<Dynamics, Failure> {
    let sized = along.filter(|along| along.design == Design::Smoothing);
    if let (true, Some(reason)) = (options.get_flag("exact"), info.only_form()) {
        return Err(Failure::usage(format!("`--exact`: {reason}")));
    }
    let Some(word) = text(options, "smooth") else {
        return match sized {
            Some(along) => Err(Failure::usage(format!(
                "`--along smooth=...` follows the size of a smoothing: name its kernel, for instance `--smooth arctan:{:e}`",
                along.from
            ))),
            None if info.contacts.is_empty() => Ok(Dynamics::Smooth),
            None => Ok(Dynamics::Exact),
        };
    };
    if options.get_flag("exact") {
        return Err(Failure::usage(format!(
            "`--exact` and `--smooth {word}` exclude each other"
        )));
    }
    if let Some(reason) = info.only_form() {
        return Err(Failure::usage(format!("`--smooth {word}`: {reason}")));
    }
    if info.contacts.is_empty() {
        return Err(Failure::usage(format!(
            "`--smooth {word}`: `{}` has no friction that could be smoothed",
            info.command
        )));
    }
    // Followed along its size, a smoothing begins at the beginning of the range.
    let full = match sized {
        Some(along) if !word.contains(':') => format!("{word}:{:e}", along.from),
        _ => word.to_owned(),
    };
    let smoothing: Smoothing = full
        .parse()
        .map_err(|error| Failure::usage(format!("`--smooth {word}`: {error}")))?;
    Ok(Dynamics::Smoothed(smoothing))
}

/// The size with which a followed smoothing begins, if `--smooth` says another.
fn superseded(options: &ArgMatches, along: Option<Along>) -> Option<f64> {
    let from = along
        .filter(|along| along.design == Design::Smoothing)?
        .from;
    let given: Smoothing = text(options, "smooth")?.parse().ok()?;
    (given.size != from).then_some(from)
}

fn start(info: &ModelInfo, word: &str) -> Result<Vec<f64>, Failure> {
    let mut given: Vec<Option<f64>> = vec![None; info.states.len()];
    for pair in word.split(',') {
        let (name, value) = assignment("--start", pair)?;
        let Some(place) = info.states.iter().position(|state| state.name == name) else {
            let names: Vec<&str> = info.states.iter().map(|state| state.name).collect();
            let what = format!("`{}` has no state", info.command);
            return Err(Failure::usage(unknown(&what, name, &names)));
        };
        if given[place].is_some() {
            return Err(Failure::usage(format!(
                "`--start {word}` gives `{name}` more than once"
            )));
        }
        given[place] = Some(number(&format!("--start {pair}"), value)?);
    }
    let declared = info.states.iter().map(|state| state.start);
    Ok(given
        .into_iter()
        .zip(declared)
        .map(|(given, start)| given.unwrap_or(start))
        .collect())
}

fn accuracy(word: &str) -> Result<f64, Failure> {
    let value = number("--accuracy", word)?;
    if value > 1e-13 && value < 1e-1 {
        return Ok(value);
    }
    Err(Failure::usage(format!(
        "`--accuracy {word}` is out of reach: a relative accuracy lies between 1e-13 and 1e-1"
    )))
}

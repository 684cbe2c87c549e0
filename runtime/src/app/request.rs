//! What is asked of which model, and where the answer goes: the arguments that commands share, as a case.

use super::arguments::Subject;
use super::document::Document;
use super::failure::{Failure, refuse};
use super::offer::App;
use super::output::Output;
use super::saved::{Saved, Start};
use super::values::{Assignment, Range, SMOOTH};
use super::words::place;
use crate::field::{Design, Smoothing};
use crate::model::ModelInfo;
use crate::study::{Along, Case, Dynamics, StudyError, System};

/// A question to a model.
pub(super) struct Request<'a> {
    pub(super) entry: &'a System,
    pub(super) info: &'static ModelInfo,
    pub(super) case: Case,
    pub(super) output: Output,
}

/// Reads a request; nothing has been computed or written yet.
pub(super) fn request<'a>(
    app: &'a App,
    subject: &Subject,
    range: Option<&Range>,
    period: Option<f64>,
) -> Result<Request<'a>, Failure> {
    let entry = model(app, subject)?;
    let info = entry.info();
    let along = range
        .map(|range| along(info, "--along", range))
        .transpose()?;
    let saved = match &subject.start {
        Some(Start::Saved(named)) => Some(named.of(info)?),
        _ => None,
    };
    let case = case(info, subject, along, saved.as_ref())?;
    let case = Case {
        period: period.or(case.period),
        ..case
    };
    entry.check(&case).map_err(|error| Failure::of(&error))?;
    let output = Output::open(&subject.destination)?.about(Document::case(info, &case));
    if let Some(size) = superseded(subject, along) {
        output.note(format!(
            "note: the smoothing begins at the size {size}, as `--along` says"
        ));
    }
    if let (Some(saved), Some(along)) = (&saved, along)
        && let Some(value) = elsewhere(saved, along)
    {
        let (name, from) = (along.name(info), along.from);
        output.note(format!(
            "note: what was saved lies at {name} = {value}, and is a guess at {name} = {from}, where `--along` begins"
        ));
    }
    Ok(Request {
        entry,
        info,
        case,
        output,
    })
}

/// What the arguments say of a case, and, where they are silent, what was saved.
fn case(
    info: &ModelInfo,
    subject: &Subject,
    along: Option<Along>,
    saved: Option<&Saved>,
) -> Result<Case, Failure> {
    let known = saved.and_then(|saved| saved.dynamics);
    let mut case = Case::declared(info, dynamics(info, subject, along, known)?);
    case.along = along;
    for &(index, value) in saved.into_iter().flat_map(|saved| &saved.parameters) {
        case.parameters[index] = value;
    }
    set(info, &subject.settings.set, &mut case)?;
    if let Some(along) = along {
        case = case.at(along.from);
    }
    case.start = match &subject.start {
        Some(Start::Given(given)) => Some(begin(info, given)?),
        _ => saved.map(|saved| saved.state.clone()),
    };
    case.modes = saved.map_or_else(Vec::new, |saved| saved.modes.clone());
    case.period = saved.and_then(|saved| saved.period);
    case.accuracy = subject.accuracy.unwrap_or(case.accuracy);
    Ok(case)
}

/// The value of what is followed where something was saved, if it is not where that begins.
fn elsewhere(saved: &Saved, along: Along) -> Option<f64> {
    let index = along.design.parameter()?;
    let known = saved.parameters.iter().find(|(known, _)| *known == index);
    known
        .map(|(_, value)| *value)
        .filter(|value| *value != along.from)
}

impl Request<'_> {
    /// What the question ran into.
    pub(super) fn failed(&self, error: StudyError) -> Failure {
        Failure::of(&error)
    }

    /// An answer, or what the question ran into.
    pub(super) fn got<T>(&self, answer: Result<T, StudyError>) -> Result<T, Failure> {
        answer.map_err(|error| self.failed(error))
    }

    /// What is followed.
    ///
    /// # Errors
    /// Nothing is.
    pub(super) fn along(&self) -> Result<Along, Failure> {
        let along = self.case.along;
        along.ok_or_else(|| self.failed(StudyError::NothingToFollow))
    }
}

fn model<'a>(app: &'a App, subject: &Subject) -> Result<&'a System, Failure> {
    let Some(name) = &subject.model else {
        let names = app.names().join(", ");
        return refuse!("no model is named: there are {names}");
    };
    app.entry(name)
}

/// The place of the state of this name.
pub(super) fn state(info: &ModelInfo, name: &str) -> Result<usize, Failure> {
    let names: Vec<&str> = info.states.iter().map(|state| state.name).collect();
    place(&format!("`{}` has no state", info.command), name, &names)
}

/// The place of the parameter of this name; `also` can be meant, too.
fn parameter(info: &ModelInfo, name: &str, also: &[&'static str]) -> Result<usize, Failure> {
    if info.states.iter().any(|state| state.name == name) {
        return refuse!(
            "`{name}` is a state of `{}`, not a parameter: `--start {name}=...` says where it begins",
            info.command
        );
    }
    let declared = info.parameters.iter().map(|declared| declared.name);
    let names: Vec<&str> = declared.chain(also.iter().copied()).collect();
    place(
        &format!("`{}` has no parameter", info.command),
        name,
        &names,
    )
}

/// That the parameter may have this value.
fn bounded(info: &ModelInfo, index: usize, option: &str, value: f64) -> Result<(), Failure> {
    let verdict = info
        .parameters
        .get(index)
        .map_or(Ok(()), |declared| declared.check(value));
    verdict.map_err(|error| Failure::usage(format!("`{option}`: {error}")))
}

/// Sets parameters as `--set` says.
pub(super) fn set(info: &ModelInfo, all: &[Assignment], case: &mut Case) -> Result<(), Failure> {
    let mut done = vec![false; case.parameters.len()];
    for Assignment { word, name, value } in all {
        let index = parameter(info, name, &[])?;
        bounded(info, index, &format!("--set {word}"), *value)?;
        if std::mem::replace(&mut done[index], true) {
            return refuse!("`--set {name}=...` is given more than once");
        }
        if let Some(along) = case.along
            && along.design == Design::Parameter(index)
        {
            agrees(word, *value, "--along", name, along)?;
        }
        case.parameters[index] = *value;
    }
    Ok(())
}

/// That `--set` gives what is followed its beginning.
pub(super) fn agrees(
    word: &str,
    value: f64,
    option: &str,
    name: &str,
    Along { from, to, .. }: Along,
) -> Result<(), Failure> {
    if value == from {
        return Ok(());
    }
    refuse!(
        "`--set {word}` contradicts `{option} {name}={from}..{to}`, which begins at {name} = {from}"
    )
}

/// What the range of this option follows.
pub(super) fn along(info: &ModelInfo, option: &str, range: &Range) -> Result<Along, Failure> {
    let option = format!("{option} {}", range.word);
    let design = match range.name.as_str() {
        SMOOTH => Design::Smoothing,
        name => Design::Parameter(parameter(info, name, &[SMOOTH])?),
    };
    let (from, to) = (range.from, range.to);
    if let Design::Parameter(index) = design {
        bounded(info, index, &option, from)?;
        bounded(info, index, &option, to)?;
    }
    Ok(Along { design, from, to })
}

fn dynamics(
    info: &ModelInfo,
    subject: &Subject,
    along: Option<Along>,
    saved: Option<Dynamics>,
) -> Result<Dynamics, Failure> {
    let sized = along.filter(|along| along.design == Design::Smoothing);
    if let (true, Some(reason)) = (subject.exact, info.only_form()) {
        return refuse!("`--exact`: {reason}");
    }
    let Some(copy) = &subject.smooth else {
        return unsaid(info, sized, saved.filter(|_| !subject.exact));
    };
    let word = &copy.word;
    if subject.exact {
        return refuse!("`--exact` and `--smooth {word}` exclude each other");
    }
    if let Some(reason) = info.only_form() {
        return refuse!("`--smooth {word}`: {reason}");
    }
    if !info.touches() {
        return refuse!(
            "`--smooth {word}`: `{}` has no contact that could be smoothed",
            info.command
        );
    }
    // Followed along its size, a smoothing begins at the beginning of the range.
    let smoothing = match (&copy.smoothing, sized) {
        (Err(_), Some(along)) => Smoothing {
            kernel: copy.kernel,
            size: along.from,
        },
        _ => copy.sized()?,
    };
    Ok(Dynamics::Smoothed(smoothing))
}

/// How friction acts where nothing is said of it: as it did, or by its law.
fn unsaid(
    info: &ModelInfo,
    sized: Option<Along>,
    saved: Option<Dynamics>,
) -> Result<Dynamics, Failure> {
    match (saved, sized) {
        (Some(Dynamics::Smoothed(saved)), Some(along)) => Ok(Dynamics::Smoothed(Smoothing {
            size: along.from,
            ..saved
        })),
        (_, Some(along)) => Err(kernel_missing("--along smooth=...", &along)),
        _ if !info.touches() => Ok(Dynamics::Smooth),
        (saved, None) => Ok(saved.unwrap_or(Dynamics::Exact)),
    }
}

/// That the size of a smoothing is followed which nobody has named.
pub(super) fn kernel_missing(option: &str, along: &Along) -> Failure {
    Failure::usage(format!(
        "`{option}` follows the size of a smoothing: name its kernel, for instance `--smooth arctan:{:e}`",
        along.from
    ))
}

/// The size with which a followed smoothing begins, if `--smooth` says another.
fn superseded(subject: &Subject, along: Option<Along>) -> Option<f64> {
    let from = along
        .filter(|along| along.design == Design::Smoothing)?
        .from;
    let given = subject.smooth.as_ref()?.smoothing.as_ref().ok()?;
    (given.size != from).then_some(from)
}

/// The declared start but for what is given.
fn begin(info: &ModelInfo, given: &[Assignment]) -> Result<Vec<f64>, Failure> {
    let mut start: Vec<f64> = info.states.iter().map(|state| state.start).collect();
    for one in given {
        start[state(info, &one.name)?] = one.value;
    }
    Ok(start)
}

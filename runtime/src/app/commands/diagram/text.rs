//! A diagram as text.

use crate::app::section::unmet;
use crate::app::text::{followed, heading, number, table, work};
use crate::model::ModelInfo;
use crate::poincare::Silence;
use crate::study::{Case, DiagramRecord, Slice};

/// Digits shown of the design variable.
const DIGITS: usize = 6;

pub(super) fn describe(info: &ModelInfo, case: &Case, record: &DiagramRecord) -> String {
    let name = &followed(info, &record.along);
    let section = record.diagram.section.describe(info);
    let what = format!("a Poincaré diagram along {name}, section {section}");
    let mut lines = format!("sweep\t{name}\tto\tvalues\tmotion\n");
    for sweep in &record.sweeps {
        let kind = |slice: &Slice| slice.motion.name();
        for run in sweep.slices.chunk_by(|a, b| kind(a) == kind(b)) {
            lines += &format!("{}\t{}\n", sweep.name, describe_run(run));
        }
    }
    let count: usize = record.sweeps.iter().map(|sweep| sweep.slices.len()).sum();
    let tail = format!("\n  {count} values; {}\n", work(&record.work()));
    heading(info, case, &what) + &table(&lines) + &elsewhere(info, record) + &tail
}

/// What `elsewhere` means, at the first value of each sweep where it is said.
fn elsewhere(info: &ModelInfo, record: &DiagramRecord) -> String {
    let name = record.along.name(info);
    let section = &record.diagram.section;
    let first = |slices: &[Slice]| {
        let mut seen = slices
            .iter()
            .filter_map(|slice| Some((slice.r, slice.silence.clone()?)));
        seen.next()
    };
    let sentence = |(r, silence): (f64, Silence)| {
        let why = unmet(info, section, &silence);
        format!("\n  elsewhere: at {name} = {}, {why}\n", number(r, DIGITS))
    };
    let all = record
        .sweeps
        .iter()
        .filter_map(|sweep| first(&sweep.slices));
    all.map(sentence).collect()
}

/// Neighbouring values with the same kind of motion.
fn describe_run(run: &[Slice]) -> String {
    let end = |slice: Option<&Slice>| slice.map_or(String::new(), |s| number(s.r, DIGITS));
    let motion = run.first().map_or(String::new(), |s| s.motion.name());
    let (from, to, exponents) = (end(run.first()), end(run.last()), exponents(run));
    format!("{from}\t{to}\t{}\t{motion}{exponents}", run.len())
}

/// The range of the Lyapunov exponents of a run.
fn exponents(run: &[Slice]) -> String {
    let values = || {
        let known = run.iter().filter_map(|slice| slice.lyapunov.as_ref());
        known.filter_map(|found| found.as_ref().ok()?.exponent)
    };
    let (low, high) = (
        values().fold(f64::INFINITY, f64::min),
        values().fold(f64::NEG_INFINITY, f64::max),
    );
    if low > high {
        return String::new();
    }
    format!(", exponent {} to {}", number(low, 3), number(high, 3))
}

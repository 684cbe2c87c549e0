//! A diagram as text.

use crate::app::text::{followed, number, parameters, table, work};
use crate::model::ModelInfo;
use crate::study::{Case, DiagramRecord, Slice, SweepRecord};

/// Digits shown of the design variable.
const DIGITS: usize = 6;

pub(super) fn describe(info: &ModelInfo, case: &Case, record: &DiagramRecord) -> String {
    let name = &followed(info, &record.along);
    let section = record.diagram.section.describe(info);
    let mut text = format!(
        "{}, {}: a Poincaré diagram along {name}, section {section}\n  {}\n\n",
        info.command,
        case.dynamics,
        parameters(info, case)
    );
    let head = ["sweep", name, "to", "values", "motion"].map(str::to_owned);
    let mut rows = vec![head.to_vec()];
    for sweep in &record.sweeps {
        rows.extend(runs(sweep).iter().map(|run| row(sweep, run)));
    }
    text.push_str(&table(&rows));
    let count: usize = record.sweeps.iter().map(|sweep| sweep.slices.len()).sum();
    text.push_str(&format!("\n  {count} values; {}\n", work(&record.work())));
    text
}

/// Neighbouring values with the same kind of motion.
fn runs(sweep: &SweepRecord) -> Vec<&[Slice]> {
    let kind = |slice: &Slice| slice.motion.name();
    sweep.slices.chunk_by(|a, b| kind(a) == kind(b)).collect()
}

fn row(sweep: &SweepRecord, run: &[Slice]) -> Vec<String> {
    let end = |slice: Option<&Slice>| slice.map_or(String::new(), |s| number(s.r, DIGITS));
    let motion = run.first().map_or(String::new(), |s| s.motion.name());
    vec![
        sweep.name.to_owned(),
        end(run.first()),
        end(run.last()),
        run.len().to_string(),
        motion + &exponents(run),
    ]
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

//! The map of the extremes: over which ranges of parameters and of ε answers keep their digits, and what stops them.

mod limits;
mod page;
mod ranges;

use std::path::Path;

use stickslip::report::{ReportError, Written};
use stickslip::study::{Case, OrbitRecord, StudyError, parallel};

use super::Part;
use super::ask::Subject;
pub(super) use page::section;
pub use ranges::{Expected, Range, ranges};

/// What became of one cell of the map.
#[derive(Debug, Clone, PartialEq)]
pub struct Cell {
    /// The value of what is varied.
    pub value: f64,
    /// What the map is to hold here.
    pub expected: Expected,
    /// What it holds.
    pub outcome: Outcome,
}

/// An answer with its digits, or the reason why there is none.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// An orbit.
    Found {
        /// Decimal digits that a tighter run and the known limits confirm, of period and extrema.
        digits: f64,
        /// Decimal digits that the answer claims for itself.
        claimed: f64,
        /// Whether its error is as small as it claims, as far as the tighter run can tell.
        honest: bool,
        /// Its period.
        period: f64,
    },
    /// No orbit, and why.
    Refused {
        /// The kind of the error.
        kind: &'static str,
        /// Its message.
        reason: String,
    },
}

/// How accurately the cells are computed, and how accurately the runs that confirm them: the first that converges.
const ACCURACY: f64 = 1e-9;
const TIGHT: [f64; 3] = [1e-12, 1e-11, 1e-10];

/// Writes a map as a page to the folder `out`.
///
/// # Errors
/// A file cannot be written.
pub fn draw(map: &[(Range, Vec<Cell>)], out: &Path) -> Result<Written, ReportError> {
    let mut report = Part::Extremes.begin(out)?;
    report.add(section(map)?)?;
    Ok(report.written())
}

/// Every cell of every range.
#[must_use]
pub fn map() -> Vec<(Range, Vec<Cell>)> {
    let ranges = ranges();
    let all: Vec<(&Range, (f64, Expected))> = ranges
        .iter()
        .flat_map(|range| range.cells.iter().map(move |cell| (range, *cell)))
        .collect();
    let found = parallel(&all, |&(range, (value, expected))| Cell {
        value,
        expected,
        outcome: range.outcome(value),
    });
    let mut found = found.into_iter();
    let of = |range: Range| {
        let count = range.cells.len();
        (range, found.by_ref().take(count).collect())
    };
    ranges.into_iter().map(of).collect()
}

impl Range {
    /// What becomes of the orbit at this value.
    #[must_use]
    pub fn outcome(&self, value: f64) -> Outcome {
        let (subject, case) = (&self.subject, self.case(value));
        let orbit = match subject.orbit(&case) {
            Ok(orbit) => orbit,
            Err(error) => {
                return Outcome::Refused {
                    kind: kind(&error),
                    reason: error.to_string(),
                };
            }
        };
        let known = (self.known)(&case, value);
        let known = known
            .iter()
            .map(|limit| limit.error(&orbit))
            .reduce(f64::max);
        let tight = TIGHT
            .iter()
            .find_map(|&accuracy| tighter(subject, &case, &orbit, accuracy));
        let tight = tight.map(|tight| (difference(&orbit, &tight), tight.error_estimate));
        let Some(error) = known
            .into_iter()
            .chain(tight.map(|(error, _)| error))
            .reduce(f64::max)
        else {
            return Outcome::Refused {
                kind: "unconfirmed",
                reason: "no tighter run confirms it".to_owned(),
            };
        };
        let doubt = tight.map_or(0.0, |(_, estimate)| estimate);
        Outcome::Found {
            digits: digits(error),
            claimed: digits(orbit.error_estimate),
            honest: error <= orbit.error_estimate + doubt,
            period: orbit.period,
        }
    }
}

/// The same orbit, computed more tightly.
fn tighter(
    subject: &Subject,
    case: &Case,
    orbit: &OrbitRecord,
    accuracy: f64,
) -> Option<OrbitRecord> {
    let case = Case {
        accuracy,
        start: Some(orbit.state.clone()),
        period: Some(orbit.period),
        ..case.clone()
    };
    subject.orbit(&case).ok()
}

/// Largest relative difference of period and extrema.
fn difference(a: &OrbitRecord, b: &OrbitRecord) -> f64 {
    let extrema = |of: fn(&OrbitRecord) -> &Vec<f64>| {
        let pairs = of(a).iter().zip(of(b)).zip(&b.max_abs);
        pairs.map(|((x, y), size)| (x - y).abs() / size.max(f64::MIN_POSITIVE))
    };
    extrema(|orbit| &orbit.max)
        .chain(extrema(|orbit| &orbit.min))
        .fold((a.period / b.period - 1.0).abs(), f64::max)
}

/// Decimal digits of a relative error.
fn digits(error: f64) -> f64 {
    (-error.max(1e-16).log10()).max(0.0)
}

/// The name of an error's kind.
fn kind(error: &StudyError) -> &'static str {
    use stickslip::shooting::OrbitError;
    match error {
        StudyError::Orbit(OrbitError::Equilibrium { .. }) => "equilibrium",
        StudyError::Orbit(OrbitError::NotIsolated { .. }) => "not isolated",
        StudyError::Orbit(OrbitError::NotSettled { .. }) => "not settled",
        StudyError::Orbit(OrbitError::Newton(_)) => "newton",
        StudyError::Orbit(OrbitError::Flow(_)) | StudyError::Flow(_) => "flow",
        _ => "other",
    }
}

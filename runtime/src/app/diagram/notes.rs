//! Values of a diagram as lines, with every digit.

use serde::{Deserialize, Serialize};

use crate::app::spreadsheet::full;
use crate::field::Work;
use crate::lyapunov::Lyapunov;
use crate::study::{Motion, Slice};

/// A number that comes back as it went: JSON knows no infinity, and not every reader of it keeps the last bit.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(into = "String", try_from = "String")]
struct Exact(f64);

impl From<Exact> for String {
    fn from(number: Exact) -> Self {
        full(&number.0)
    }
}

impl TryFrom<String> for Exact {
    type Error = std::num::ParseFloatError;

    fn try_from(word: String) -> Result<Self, Self::Error> {
        word.parse().map(Self)
    }
}

#[derive(Serialize, Deserialize)]
struct Line {
    sweep: String,
    r: Exact,
    motion: Kind,
    points: Vec<Vec<Exact>>,
    min: Vec<Exact>,
    max: Vec<Exact>,
    end: Vec<Exact>,
    lyapunov: Option<Result<Exponent, String>>,
    work: [u64; 7],
}

/// A Lyapunov exponent, its error, and the time over which it was averaged.
type Exponent = (Option<Exact>, Exact, Exact);

#[derive(Serialize, Deserialize)]
enum Kind {
    Periodic(usize),
    Aperiodic,
    Rest,
    Elsewhere,
    Failed(String),
}

/// A value of a sweep as a line.
pub(super) fn written(sweep: &str, slice: &Slice) -> Option<String> {
    let line = Line {
        sweep: sweep.to_owned(),
        r: Exact(slice.r),
        motion: match &slice.motion {
            Motion::Periodic(count) => Kind::Periodic(*count),
            Motion::Aperiodic => Kind::Aperiodic,
            Motion::Rest => Kind::Rest,
            Motion::Elsewhere => Kind::Elsewhere,
            Motion::Failed(reason) => Kind::Failed(reason.clone()),
        },
        points: slice.points.iter().map(|point| exactly(point)).collect(),
        min: exactly(&slice.min),
        max: exactly(&slice.max),
        end: exactly(&slice.end),
        lyapunov: slice.lyapunov.as_ref().map(|found| {
            let found = found.as_ref().map_err(Clone::clone)?;
            Ok((
                found.exponent.map(Exact),
                Exact(found.error),
                Exact(found.time),
            ))
        }),
        work: counts(&slice.work),
    };
    serde_json::to_string(&line).ok()
}

/// The value that a line tells of, and its sweep.
pub(super) fn read(line: &str) -> Option<(String, Slice)> {
    let line: Line = serde_json::from_str(line).ok()?;
    let slice = Slice {
        r: line.r.0,
        motion: match line.motion {
            Kind::Periodic(count) => Motion::Periodic(count),
            Kind::Aperiodic => Motion::Aperiodic,
            Kind::Rest => Motion::Rest,
            Kind::Elsewhere => Motion::Elsewhere,
            Kind::Failed(reason) => Motion::Failed(reason),
        },
        points: line.points.iter().map(|point| plain(point)).collect(),
        min: plain(&line.min),
        max: plain(&line.max),
        end: plain(&line.end),
        lyapunov: line.lyapunov.map(|found| {
            let (exponent, error, time) = found?;
            Ok(Lyapunov {
                exponent: exponent.map(|exponent| exponent.0),
                error: error.0,
                time: time.0,
            })
        }),
        work: work(line.work),
    };
    Some((line.sweep, slice))
}

fn exactly(values: &[f64]) -> Vec<Exact> {
    values.iter().copied().map(Exact).collect()
}

fn plain(values: &[Exact]) -> Vec<f64> {
    values.iter().map(|value| value.0).collect()
}

fn counts(work: &Work) -> [u64; 7] {
    [
        work.steps,
        work.rejected,
        work.evaluations,
        work.linearisations,
        work.factorisations,
        work.events,
        work.newton,
    ]
}

fn work(counts: [u64; 7]) -> Work {
    let [
        steps,
        rejected,
        evaluations,
        linearisations,
        factorisations,
        events,
        newton,
    ] = counts;
    Work {
        steps,
        rejected,
        evaluations,
        linearisations,
        factorisations,
        events,
        newton,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_bit_comes_back() {
        let slice = Slice {
            r: 0.1 + 0.2,
            motion: Motion::Periodic(3),
            points: vec![vec![1.0 / 3.0, -0.0], vec![5e-324, 1e308]],
            min: vec![f64::MIN_POSITIVE],
            max: vec![f64::INFINITY],
            end: vec![-1.0e-17],
            lyapunov: Some(Ok(Lyapunov {
                exponent: None,
                error: f64::INFINITY,
                time: 7.0,
            })),
            work: work([1, 2, 3, 4, 5, 6, 7]),
        };
        let failed = Slice {
            motion: Motion::Failed("at \"t\" = 1\n".to_owned()),
            lyapunov: Some(Err("no".to_owned())),
            ..slice.clone()
        };
        for slice in [slice, failed] {
            let line = written("up", &slice).unwrap();
            assert!(!line.contains('\n'));
            let (sweep, back) = read(&line).unwrap();
            assert_eq!((sweep.as_str(), &back), ("up", &slice));
            let signs = |slice: &Slice| slice.points[0][1].is_sign_negative();
            assert!(signs(&slice) && signs(&back));
        }
        assert!(read("{\"sweep\":\"up\"").is_none());
    }
}

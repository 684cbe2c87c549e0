//! Error against cost as JSON.

mod copy;
mod precision;

use copy::{Copy, copy};
use precision::{WorkPrecision, work_precision};

use super::work::Counts;
use super::{Named, parameters, states, units};
use crate::field::Kernel;
use crate::model::ModelInfo;
use crate::study::trade::{Cost, Curve, Fit, Need, Setting, Truth};
use crate::study::{End, TradeRecord};

/// A trade.
#[derive(serde::Serialize)]
pub(in super::super) struct Trade<'a> {
    model: &'a str,
    along: Option<Range<'a>>,
    ends: Vec<AtEnd<'a>>,
    /// Where a range is judged: the most demanding end of each kernel.
    worst: Vec<Worst>,
    /// Whether it was ended before all of this was there.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    interrupted: bool,
    units: Named<'a, &'static str>,
}

#[derive(serde::Serialize)]
struct Range<'a> {
    name: &'a str,
    from: f64,
    to: f64,
}

#[derive(serde::Serialize)]
struct Worst {
    kernel: &'static str,
    end: usize,
    need: Answer<Needed>,
}

#[derive(serde::Serialize)]
struct AtEnd<'a> {
    parameters: Named<'a, f64>,
    exact: Exact<'a>,
    smoothings: Vec<Kind<'a>>,
    work_precision: Vec<WorkPrecision<'a>>,
}

#[derive(serde::Serialize)]
struct Exact<'a> {
    period: f64,
    frequency: f64,
    max_abs: Named<'a, f64>,
    period_count: usize,
    cost: Price,
    need: Option<Answer<Set>>,
}

/// What was found, or why nothing was.
#[derive(serde::Serialize)]
#[serde(untagged)]
enum Answer<T> {
    Found(T),
    Missing { reason: String },
}

impl<T> Answer<T> {
    fn of<S>(result: &Result<S, String>, found: impl Fn(&S) -> T) -> Self {
        match result {
            Ok(value) => Self::Found(found(value)),
            Err(reason) => Self::Missing {
                reason: reason.clone(),
            },
        }
    }
}

/// One period with derivatives and extrema.
#[derive(serde::Serialize)]
struct Price {
    seconds: f64,
    work: Counts,
}

#[derive(serde::Serialize)]
struct Set {
    tolerance: f64,
    error: f64,
    cost: Price,
}

#[derive(serde::Serialize)]
struct Needed {
    smoothing: String,
    size: f64,
    size_for_frequency: f64,
    error: f64,
    setting: Set,
}

#[derive(serde::Serialize)]
struct Kind<'a> {
    kernel: &'static str,
    refused: Option<String>,
    points: Vec<Copy<'a>>,
    lost: Vec<Lost<'a>>,
    fits: Option<Fits<'a>>,
    need: Option<Answer<Needed>>,
}

#[derive(serde::Serialize)]
struct Lost<'a> {
    size: f64,
    reason: &'a str,
}

/// e = b ε^a.
#[derive(serde::Serialize)]
struct Fits<'a> {
    frequency: Option<Line>,
    max_abs: Named<'a, Option<Line>>,
}

#[derive(serde::Serialize)]
struct Line {
    a: f64,
    b: f64,
}

impl<'a> Trade<'a> {
    pub(in super::super) fn new(info: &'a ModelInfo, record: &'a TradeRecord) -> Self {
        let worst = |kernel: Kernel| {
            let (end, need) = record.need(kernel)?;
            Some(Worst {
                kernel: kernel.name(),
                end,
                need: Answer::of(&need, needed),
            })
        };
        Self {
            model: info.command,
            along: record.along.as_ref().map(|along| Range {
                name: along.name(info),
                from: along.from,
                to: along.to,
            }),
            ends: record.ends.iter().map(|end| at_end(info, end)).collect(),
            worst: Kernel::ALL.into_iter().filter_map(worst).collect(),
            interrupted: record.is_interrupted(),
            units: units(info),
        }
    }
}

fn at_end<'a>(info: &'a ModelInfo, end: &'a End) -> AtEnd<'a> {
    let trade = &end.trade;
    AtEnd {
        parameters: parameters(info, &end.parameters),
        exact: exact(info, &trade.exact, trade.need.as_ref()),
        smoothings: trade.curves.iter().map(|curve| kind(info, curve)).collect(),
        work_precision: trade.precision.iter().map(work_precision).collect(),
    }
}

fn exact<'a>(
    info: &'a ModelInfo,
    truth: &Truth,
    need: Option<&Result<Setting, String>>,
) -> Exact<'a> {
    Exact {
        period: truth.period,
        frequency: 1.0 / truth.period,
        max_abs: states(info, truth.max_abs.clone()),
        period_count: truth.period_count,
        cost: price(&truth.cost),
        need: need.map(|need| Answer::of(need, set)),
    }
}

fn price(cost: &Cost) -> Price {
    Price {
        seconds: cost.seconds,
        work: Counts::from(&cost.work),
    }
}

fn set(setting: &Setting) -> Set {
    Set {
        tolerance: setting.tolerance,
        error: setting.error,
        cost: price(&setting.cost),
    }
}

fn needed(need: &Need) -> Needed {
    Needed {
        smoothing: need.smoothing.to_string(),
        size: need.smoothing.size,
        size_for_frequency: need.frequency_size,
        error: need.error,
        setting: set(&need.setting),
    }
}

fn kind<'a>(info: &'a ModelInfo, curve: &'a Curve) -> Kind<'a> {
    let line = |fit: &Option<Fit>| fit.map(|Fit { a, b }| Line { a, b });
    let lost = curve.lost.iter();
    Kind {
        kernel: curve.kernel.name(),
        refused: curve.refused.as_ref().map(ToString::to_string),
        points: curve.points.iter().map(|p| copy(info, curve, p)).collect(),
        lost: lost
            .map(|(size, reason)| Lost {
                size: *size,
                reason,
            })
            .collect(),
        fits: curve.refused.is_none().then(|| Fits {
            frequency: line(&curve.frequency),
            max_abs: states(info, curve.max_abs.iter().map(line).collect::<Vec<_>>()),
        }),
        need: curve.need.as_ref().map(|need| Answer::of(need, needed)),
    }
}

//! What smoothing costs, and what it gets wrong: the belt oscillator with every smoothing beside the exact system.

use std::time::Duration;

use stickslip::field::{Kernel, Work};
use stickslip::report::numerals::{count, decimals, duration, power, scientific};
use stickslip::report::{Curve, Manuscript, Section};
use stickslip::study::parallel;
use stickslip::study::trade::{Point, Precision, Scope, Setting, Trade};

use super::ReproduceError;
use super::ask::Subject;
use crate::BeltOscillator;

/// The belt speed of the comparison.
const SPEED: f64 = 0.2;
/// The accuracy for which the cheapest settings are sought.
const ACCURACY: f64 = 1e-3;
/// Smoothings of sgn that the belt oscillator's law accepts.
const KERNELS: [Kernel; 5] = [
    Kernel::Arctan,
    Kernel::Algebraic,
    Kernel::Tanh,
    Kernel::Cubic,
    Kernel::Quintic,
];

/// The section on the trade.
pub(super) fn section() -> Result<Section, ReproduceError> {
    let belt = Subject::new(BeltOscillator::v_dr);
    let trades: Vec<Vec<Trade>> = parallel(&KERNELS, |&kernel| measure(&belt, kernel))
        .into_iter()
        .collect::<Result<_, _>>()?;
    let trades = trades.concat();
    let manuscript = Manuscript::new(include_str!("smoothing.md"))
        .curves("A.1", [curves(&trades)])
        .rows("needs", needs(&trades))
        .rows("predictions", predictions(&trades));
    Ok(manuscript.section()?)
}

/// The belt oscillator with one smoothing at all sizes and tolerances, and exact.
fn measure(belt: &Subject, kernel: Kernel) -> Result<Vec<Trade>, ReproduceError> {
    let scope = Scope {
        kernels: vec![kernel],
        accuracy: Some(ACCURACY),
        ..Scope::default()
    };
    belt.trade(SPEED, &scope)
}

/// The settings at which each system meets the accuracy at least cost.
fn needs(trades: &[Trade]) -> Vec<Vec<String>> {
    let exact = trades.first().and_then(|trade| {
        let setting = trade.need.as_ref()?.as_ref().ok()?;
        Some(needed("exact", ["–".to_owned(), "–".to_owned()], setting))
    });
    let copies = trades.iter().filter_map(|trade| {
        let curve = trade.curves.first()?;
        let need = curve.need.as_ref()?.as_ref().ok()?;
        let sizes = [need.frequency_size, need.smoothing.size].map(|size| scientific(size, 1));
        Some(needed(&curve.kernel.to_string(), sizes, &need.setting))
    });
    exact.into_iter().chain(copies).collect()
}

fn needed(name: &str, [by_frequency, by_all]: [String; 2], setting: &Setting) -> Vec<String> {
    vec![
        name.to_owned(),
        by_frequency,
        by_all,
        scientific(setting.tolerance, 0),
        scientific(setting.error, 1),
        count(evaluations(&setting.cost.work)),
        count(setting.cost.work.factorisations),
        duration(Duration::from_secs_f64(setting.cost.seconds)),
    ]
}

/// Errors above this are of no use to anyone.
const USELESS: f64 = 1.0;
/// Errors below this are those of the exact orbit against which the others are measured.
const RESOLUTION: f64 = 1e-10;
/// A setting that costs more must be better by this factor.
const BETTER: f64 = 0.9;

/// Cost and error of every setting, from the cheapest to the most accurate, without those that another one beats.
fn best<'a>(precisions: impl Iterator<Item = &'a Precision>) -> Vec<[f64; 2]> {
    let mut all: Vec<[f64; 2]> = precisions
        .flat_map(|precision| &precision.points)
        .map(|point| [evaluations(&point.cost.work) as f64, point.total])
        .filter(|[_, error]| *error > RESOLUTION)
        .collect();
    all.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let mut least = USELESS;
    all.retain(|&[_, error]| {
        let better = error < BETTER * least;
        least = least.min(error);
        better
    });
    all
}

/// One curve for each smoothing, and the exact system.
fn curves(trades: &[Trade]) -> Vec<Curve> {
    let copies = trades.iter().enumerate().filter_map(|(i, trade)| {
        let kernel = trade.curves.first()?.kernel;
        let copies = trade.precision.iter().filter(|p| p.smoothing.is_some());
        Some(Curve::line(kernel.to_string(), i + 1, best(copies)))
    });
    let exact = trades.first().map(|trade| {
        let exact = trade.precision.iter().filter(|p| p.smoothing.is_none());
        Curve::line("exact", 0, best(exact))
    });
    copies.chain(exact).collect()
}

/// Exponents of the sizes shown.
const SHOWN: [i32; 4] = [3, 4, 5, 7];

/// Predicted and measured errors of frequency and largest displacement.
fn predictions(trades: &[Trade]) -> Vec<Vec<String>> {
    let rows = trades
        .iter()
        .flat_map(|trade| &trade.curves)
        .flat_map(|curve| {
            let shown = |point: &&Point| SHOWN.contains(&exponent(point.size));
            let points = curve.points.iter().filter(shown);
            points.map(|point| predicted(&curve.kernel.to_string(), point))
        });
    rows.collect()
}

fn predicted(kernel: &str, point: &Point) -> Vec<String> {
    let found = point.predicted.as_ref().ok();
    let frequency = found.map(|p| p.frequency);
    let extremum = found.and_then(|p| p.max_abs.first().copied().flatten());
    let measured = point.max_abs.first().copied().unwrap_or(f64::NAN);
    let doubts = found.is_none_or(|p| !p.doubts.is_empty());
    let mut row = vec![kernel.to_owned(), power(exponent(point.size))];
    row.extend(compared(frequency, point.frequency));
    row.extend(compared(extremum, measured));
    row.push(if doubts { "not yet" } else { "yes" }.to_owned());
    row
}

fn compared(predicted: Option<f64>, measured: f64) -> [String; 3] {
    let none = || "–".to_owned();
    [
        predicted.map_or_else(none, |p| scientific(p, 3)),
        scientific(measured, 3),
        predicted.map_or_else(none, |p| decimals(p / measured, 3)),
    ]
}

/// Evaluations of the equations, with or without their derivatives.
const fn evaluations(work: &Work) -> u64 {
    work.evaluations + work.linearisations
}

/// The power of ten nearest to a size.
fn exponent(size: f64) -> i32 {
    size.log10().round() as i32
}

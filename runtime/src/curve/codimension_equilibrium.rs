//! What is looked for on a curve of equilibria: points of codimension two, and where a contact no longer slides as it did.

use nalgebra::Complex;

use super::codimension::still;
use super::condition::pairs;
use super::isola::Unfolding;
use super::point::{CriticalEquilibrium, CurvePoint};
use crate::continuation::{Kind, Monitor, Verdict};

type Point = CurvePoint<CriticalEquilibrium>;

/// What is looked for on a curve of this kind.
pub(super) fn monitors<'a>(of: Kind, unfolding: &'a Unfolding) -> Vec<Monitor<'a, Point>> {
    let ends = |kind| move |_: [&Point; 2], _: &Point| Some(Verdict::Last(kind));
    let least = |point: &Point| {
        point
            .of
            .margins
            .iter()
            .map(|one| one.1)
            .fold(f64::INFINITY, f64::min)
    };
    let boundary = Monitor::new(Kind::BoundaryEquilibrium, least);
    let mut named = vec![boundary.judged(ends(Kind::BoundaryEquilibrium))];
    match of {
        Kind::Hopf => named.extend([
            Monitor::new(Kind::GeneralizedHopf, coefficient)
                .known_to(uncertainty)
                .only_if(changes)
                .judged(passes),
            // Beyond, the pair is real, and the equilibrium a neutral saddle.
            Monitor::new(Kind::BogdanovTakens, square).judged(ends(Kind::BogdanovTakens)),
            Monitor::new(Kind::ZeroHopf, |point| product(&others(point))),
            pair(Kind::DoubleHopf),
        ]),
        Kind::Fold => named.extend([
            still(unfolding, 1),
            still(unfolding, 0),
            Monitor::new(Kind::BogdanovTakens, |point| product(&others(point))),
            pair(Kind::ZeroHopf),
        ]),
        _ => {}
    }
    named
}

/// l₁; no number where it is not known.
fn coefficient(point: &Point) -> f64 {
    point.of.onset.map_or(f64::NAN, |onset| onset.coefficient)
}

/// What l₁ may be off by.
fn uncertainty(point: &Point) -> f64 {
    point.of.onset.map_or(0.0, |onset| onset.error)
}

/// Whether l₁ changes by more than it is off at either end: its sign may be that of its errors.
fn changes(ends: [&Point; 2]) -> bool {
    let [from, to] = ends.map(coefficient);
    let [a, b] = ends.map(uncertainty);
    (to - from).abs() > a.max(b)
}

/// Where l₁ changes its sign through zero, and not through infinity, as it does where eigenvalues meet.
fn passes(ends: [&Point; 2], at: &Point) -> Option<Verdict> {
    let least = ends
        .map(|end| coefficient(end).abs())
        .into_iter()
        .fold(f64::INFINITY, f64::min);
    (coefficient(at).abs() <= least).then_some(Verdict::Special(Kind::GeneralizedHopf))
}

/// The product of the pair: ω² where it turns.
fn square(point: &Point) -> f64 {
    point.of.pair.map_or(f64::NAN, |[a, b]| (a * b).re)
}

/// Where two more eigenvalues come to the sum zero, and turn.
fn pair<'a>(kind: Kind) -> Monitor<'a, Point> {
    let sums = |point: &Point| {
        let all = others(point);
        let sums = pairs(&all).map(|(a, b)| (a + b) / (a.norm() + b.norm()));
        sums.fold(Complex::new(1.0, 0.0), |all, sum| all * sum).re
    };
    Monitor::new(kind, sums).judged(move |_, at| {
        let all = others(at);
        let off = |(a, b): &(Complex<f64>, Complex<f64>)| (a + b).norm();
        let nearest = pairs(&all).min_by(|x, y| off(x).total_cmp(&off(y)))?;
        (nearest.0.im != 0.0).then_some(Verdict::Special(kind))
    })
}

/// The eigenvalues but those for which the equilibrium is special.
fn others(point: &Point) -> Vec<Complex<f64>> {
    let mut all = point.of.spectrum.eigenvalues.clone();
    let critical = point.of.pair.map_or(vec![Complex::default()], Vec::from);
    for one in critical {
        let distance = |i: &usize| (all[*i] - one).norm();
        let nearest = (0..all.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
        nearest.map(|i| all.remove(i));
    }
    all
}

/// The product of eigenvalues, each over its size: real.
fn product(all: &[Complex<f64>]) -> f64 {
    let size = all
        .iter()
        .map(|one| one.norm())
        .fold(f64::MIN_POSITIVE, f64::max);
    let scaled = all.iter().map(|one| one / size);
    scaled.fold(Complex::new(1.0, 0.0), |all, one| all * one).re
}

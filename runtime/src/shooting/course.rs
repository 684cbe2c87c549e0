//! Courses: directions along which rates do not grow, however far one goes, and shifts along them after which all repeats.
//!
//! Secants over a long way, to both sides, hear nothing of waves, only of what grows. Where they have no slope, several angles
//! may turn together, as those of a motor and what it drives through a shaft. A shift that is known nearly is sharpened by
//! Gauss's and Newton's method: all rates, relative speeds and gaps are to be at many places what they were.

use nalgebra::{DMatrix, DVector};

use super::echelon::{Echelon, Free};
use super::tried::{slopes_of_speeds, spread, velocity};
use crate::linear::svd;
use crate::motion::Flow;

/// How far secants reach, in usual sizes, and below which share of a rate over a usual size they have no slope.
const FAR: f64 = 1.0e6;
const FLAT: f64 = 1e-4;
/// Places of secants, and those at which a shift is sharpened.
const SECANTS: usize = 2;
const PLACES: usize = 4;
/// Steps of sharpening, and singular values that count, over the largest.
const STEPS: usize = 6;
const HEARD: f64 = 1e-8;

/// The directions, but for states that are known otherwise.
pub(super) fn courses(flow: &dyn Flow, usual: &[f64], known: &[usize]) -> Vec<Free> {
    let order = usual.len();
    let unit = |state: usize| (0..order).map(move |j| f64::from(j == state)).collect();
    let mut rows: Vec<Vec<f64>> = known.iter().map(|state| unit(*state)).collect();
    let near = spread(usual).filter_map(|place| rates(flow, &place));
    let sizes = near.fold(DVector::zeros(order), |most, rates| most.sup(&rates.abs()));
    for place in spread(usual).take(SECANTS) {
        rows.extend(secants(flow, &place, usual, &sizes));
        rows.extend(slopes_of_speeds(flow, &place, usual));
    }
    let heard = |row: &mut Vec<f64>| {
        let largest = row
            .iter()
            .fold(0.0_f64, |most, slope| most.max(slope.abs()));
        row.iter_mut().for_each(|slope| *slope /= largest);
        largest > 0.0 && row.iter().all(|slope| slope.is_finite())
    };
    rows.retain_mut(heard);
    rows.resize(rows.len().max(order), vec![0.0; order]);
    let matrix = DMatrix::from_fn(rows.len(), order, |i, j| rows[i][j]);
    let Some((values, vt)) = svd(matrix).and_then(|svd| Some((svd.singular_values, svd.v_t?)))
    else {
        return Vec::new();
    };
    let null = (0..order).filter(|i| values[*i] <= FLAT * values.max());
    let null: Vec<_> = null.map(|i| vt.row(i).transpose()).collect();
    Echelon::of(&null, order, &[]).directions(usual)
}

/// Slopes of the rates over a long way to both sides, over these sizes, in usual sizes of the states; along a state where rates
/// have no value, of all.
fn secants(flow: &dyn Flow, place: &[f64], usual: &[f64], sizes: &DVector<f64>) -> Vec<Vec<f64>> {
    let order = usual.len();
    let at = |j: usize, far: f64| {
        let mut there = place.to_vec();
        there[j] += far * usual[j];
        rates(flow, &there)
    };
    let columns = (0..order).map(|j| Some((at(j, FAR)? - at(j, -FAR)?) / (2.0 * FAR)));
    let columns: Vec<Option<DVector<f64>>> = columns.collect();
    let slope = |i: usize, j: usize| {
        let slope = columns[j]
            .as_ref()
            .map_or(1.0, |column| column[i] / sizes[i]);
        if slope.abs() <= FLAT { 0.0 } else { slope }
    };
    let row = |i: usize| (0..order).map(|j| slope(i, j)).collect();
    (0..order).map(row).collect()
}

fn rates(flow: &dyn Flow, state: &[f64]) -> Option<DVector<f64>> {
    let rates = velocity(flow, state)?.f;
    rates.iter().all(|rate| rate.is_finite()).then_some(rates)
}

/// The shift near this one after which rates, relative speeds and gaps repeat best; states that it does not move stay.
pub(super) fn sharper(flow: &dyn Flow, shift: &[f64], usual: &[f64]) -> Option<Vec<f64>> {
    let moved: Vec<usize> = (0..shift.len()).filter(|j| shift[*j] != 0.0).collect();
    let places: Vec<_> = spread(usual).take(PLACES).collect();
    let mut shift = shift.to_vec();
    for _ in 0..STEPS {
        let (mut off, mut slopes) = (Vec::new(), Vec::new());
        for place in &places {
            repeats(flow, (place, &shift), usual, (&mut off, &mut slopes))?;
        }
        let matrix = DMatrix::from_fn(off.len(), moved.len(), |i, k| slopes[i][moved[k]]);
        let svd = svd(matrix)?;
        let least = HEARD * svd.singular_values.max();
        let step = svd.solve(&DVector::from_vec(off), least).ok()?;
        for (k, j) in moved.iter().enumerate() {
            shift[*j] -= step[k] * usual[*j];
        }
    }
    Some(shift)
}

/// What a shift changes at a place, over how large it is, and the slopes of that in usual sizes.
fn repeats(
    flow: &dyn Flow,
    (place, shift): (&[f64], &[f64]),
    usual: &[f64],
    (off, slopes): (&mut Vec<f64>, &mut Vec<Vec<f64>>),
) -> Option<()> {
    let there: Vec<f64> = place.iter().zip(shift).map(|(y, d)| y + d).collect();
    let here = rates(flow, place)?;
    let velocity = velocity(flow, &there)?;
    for (i, before) in here.iter().enumerate() {
        let row = velocity.jacobian.row(i);
        let size = before.abs().max(f64::MIN_POSITIVE);
        off.push((velocity.f[i] - before) / size);
        slopes.push(
            row.iter()
                .zip(usual)
                .map(|(slope, unit)| slope * unit / size)
                .collect(),
        );
    }
    let [before, after] = [place, there.as_slice()].map(|state| flow.speeds(state));
    for (i, row) in slopes_of_speeds(flow, &there, usual)
        .into_iter()
        .enumerate()
    {
        let size = row
            .iter()
            .fold(f64::MIN_POSITIVE, |most, slope| most.max(slope.abs()));
        off.push((after[i] - before[i]) / size);
        slopes.push(row.iter().map(|slope| slope / size).collect());
    }
    Some(())
}

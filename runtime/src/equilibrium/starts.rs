//! Where equilibria are looked for.

use super::problem::{TINY, usual};
use crate::math::Spread;

/// Places spread around the origin.
const SPREAD: usize = 24;
/// How many times as far as equilibria that are found others are looked for.
const FURTHER: [f64; 3] = [1.0, 10.0, 100.0];
/// Share of the largest state below which another is of a size of its own.
const SMALL: f64 = 0.1;

/// `first`, the origin, and places spread evenly around both, as far as the largest state shows, and where some states are
/// of other sizes, as far as each shows: the same ones every time.
#[must_use]
pub fn starts(first: &[f64]) -> Vec<Vec<f64>> {
    let order = first.len();
    let reach = first.iter().fold(1.0_f64, |most, y| most.max(y.abs()));
    let mut places = vec![
        first.to_vec(),
        vec![0.0; order],
        first.iter().map(|y| -y).collect(),
    ];
    places.extend(within(&vec![reach; order]));
    if first
        .iter()
        .any(|y| y.abs() > TINY && y.abs() < SMALL * reach)
    {
        places.extend(within(
            &first.iter().map(|y| usual(*y)).collect::<Vec<f64>>(),
        ));
    }
    places
}

/// Places spread evenly around the origin, as far as these states show, and further.
pub(super) fn around<'a>(states: impl Iterator<Item = &'a [f64]>) -> Vec<Vec<f64>> {
    let reaches = states.fold(Vec::new(), |mut most: Vec<f64>, state| {
        most.resize(state.len(), 0.0);
        most.iter_mut()
            .zip(state)
            .for_each(|(most, y)| *most = most.max(y.abs()));
        most
    });
    let reaches = |times: &f64| {
        reaches
            .iter()
            .map(|y| times * usual(*y))
            .collect::<Vec<f64>>()
    };
    let places = FURTHER.iter().map(reaches);
    places
        .flat_map(|reaches| within(&reaches).collect::<Vec<_>>())
        .collect()
}

/// Places spread evenly around the origin, twice as far as these.
fn within(reaches: &[f64]) -> impl Iterator<Item = Vec<f64>> {
    let spread = Spread::new(reaches.len());
    (0..SPREAD).map(move |k| {
        let shares = spread.point(k).zip(reaches);
        shares
            .map(|(share, reach)| 2.0 * reach * (2.0 * share - 1.0))
            .collect()
    })
}

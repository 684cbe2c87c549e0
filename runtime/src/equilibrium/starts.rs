//! Where equilibria are looked for.

use super::problem::{TINY, usual};
use crate::math::Spread;

/// Places spread around the origin.
const SPREAD: usize = 24;
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
    let spread = Spread::new(order);
    let mut within = |reaches: &[f64]| {
        let scaled = |k: usize| {
            let shares = spread.point(k).zip(reaches);
            shares.map(|(share, reach)| 2.0 * reach * (2.0 * share - 1.0))
        };
        places.extend((0..SPREAD).map(|k| scaled(k).collect::<Vec<f64>>()));
    };
    within(&vec![reach; order]);
    if first
        .iter()
        .any(|y| y.abs() > TINY && y.abs() < SMALL * reach)
    {
        within(&first.iter().map(|y| usual(*y)).collect::<Vec<f64>>());
    }
    places
}

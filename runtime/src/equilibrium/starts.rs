//! Where equilibria are looked for.

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
    if first.iter().any(|y| *y != 0.0 && y.abs() < SMALL * reach) {
        let size = |y: &f64| if *y == 0.0 { 1.0 } else { y.abs() };
        places.extend(within(&first.iter().map(size).collect::<Vec<f64>>()));
    }
    places
}

/// Places spread evenly around the origin, as far as states of these sizes are, and further.
pub(super) fn around(sizes: &[f64]) -> Vec<Vec<f64>> {
    let further = |times: f64| sizes.iter().map(|size| times * size).collect::<Vec<f64>>();
    let reaches = FURTHER.map(further);
    reaches.iter().flat_map(|reaches| within(reaches)).collect()
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

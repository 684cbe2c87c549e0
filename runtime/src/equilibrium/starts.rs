//! Where equilibria are looked for.

use crate::math::Spread;

/// Places spread around the first one.
const SPREAD: usize = 24;

/// `first`, the origin, and places spread evenly around both: the same ones every time.
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
    let scaled = |k: usize| {
        let point = spread.point(k);
        point
            .map(|share| 2.0 * reach * (2.0 * share - 1.0))
            .collect()
    };
    places.extend((0..SPREAD).map(scaled));
    places
}

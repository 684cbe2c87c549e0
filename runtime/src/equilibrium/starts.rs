//! Where equilibria are looked for.

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
    // The positive root of xⁿ⁺¹ = x + 1 by fixed-point iteration.
    let root = (0..64).fold(1.5_f64, |x, _| (1.0 + x).powf(1.0 / (order as f64 + 1.0)));
    let scaled = |i: usize| {
        spread(i, order, root)
            .map(|share| 2.0 * reach * share)
            .collect()
    };
    places.extend((1..=SPREAD).map(scaled));
    places
}

/// Point number `i` of Roberts' sequence in [−1, 1]ⁿ, whose steps are the powers of 1/`root`.
fn spread(i: usize, order: usize, root: f64) -> impl Iterator<Item = f64> {
    (0..order).map(move |j| {
        let step = root.powi(-(j as i32 + 1));
        2.0 * (0.5 + step * i as f64).fract() - 1.0
    })
}

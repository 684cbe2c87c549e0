//! Where equilibria are looked for.

/// Places spread around the first one.
const SPREAD: usize = 24;

/// `first`, the origin, and places spread evenly around both: the same ones every time.
#[must_use]
pub fn starts<const N: usize>(first: [f64; N]) -> Vec<[f64; N]> {
    let reach = first.iter().fold(1.0_f64, |most, y| most.max(y.abs()));
    let mut places = vec![first, [0.0; N], first.map(|y| -y)];
    places.extend((1..=SPREAD).map(|i| spread(i).map(|share| 2.0 * reach * share)));
    places
}

/// Point number `i` of Roberts' sequence in [−1, 1]ᴺ.
fn spread<const N: usize>(i: usize) -> [f64; N] {
    // The positive root of xᴺ⁺¹ = x + 1 by fixed-point iteration.
    let root = (0..64).fold(1.5_f64, |x, _| (1.0 + x).powf(1.0 / (N as f64 + 1.0)));
    std::array::from_fn(|j| {
        let step = root.powi(-(j as i32 + 1));
        2.0 * (0.5 + step * i as f64).fract() - 1.0
    })
}

//! Zeros by halving, which needs nothing but a sign.

/// Where a function that rises from below zero passes it.
#[must_use]
pub fn bisected(mut low: f64, mut high: f64, of: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if of(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

//! Points spread evenly over a box, each known by its number.

/// Iterations to the root that generalises the golden ratio: more than doubles can tell.
const ITERATIONS: usize = 64;

/// The additive sequence of the root g of g^(d+1) = g + 1 in d dimensions (Roberts 2018): point k depends on nothing but
/// k, and any first n of them fill the unit cube evenly.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Spread {
    /// Shares of a turn of 2⁶⁴.
    steps: Vec<u64>,
}

impl Spread {
    pub(crate) fn new(dimension: usize) -> Self {
        let power = 1.0 / (dimension as f64 + 1.0);
        let root = (0..ITERATIONS).fold(2.0_f64, |root, _| (1.0 + root).powf(power));
        let step = |j: usize| (root.powi(-(j as i32) - 1) * 2.0_f64.powi(64)) as u64;
        let steps = (0..dimension).map(step).collect();
        Self { steps }
    }

    /// Point number `k`, each coordinate between 0 and 1.
    pub(crate) fn point(&self, k: usize) -> impl Iterator<Item = f64> + '_ {
        self.steps.iter().map(move |step| {
            let turned = step.wrapping_mul(k as u64 + 1).wrapping_add(1 << 63);
            (turned >> 11) as f64 * 2.0_f64.powi(-53)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_first_points_fill_the_cube_evenly() {
        for dimension in 1..=4 {
            let spread = Spread::new(dimension);
            for count in [100, 1000, 4000] {
                let below = |k: &usize| spread.point(*k).all(|x| x < 0.7);
                let share = (0..count).filter(below).count() as f64 / count as f64;
                let off = (share - 0.7_f64.powi(dimension as i32)).abs();
                assert!(
                    off < 3.0 * (count as f64).powf(-0.7),
                    "{dimension} {count} {off:e}"
                );
            }
        }
    }
}

//! Gauss's quadrature inside a step.

/// The nodes of Gauss-Legendre with six points that lie above the middle of [-1, 1], and their weights.
const HALF: [(f64, f64); 3] = [
    (0.238_619_186_083_196_9, 0.467_913_934_572_691_04),
    (0.661_209_386_466_264_5, 0.360_761_573_048_138_6),
    (0.932_469_514_203_152, 0.171_324_492_379_170_36),
];

/// Nodes and weights on [0, 1], divided into so many panels: exact for polynomials of degree 11 in each of them.
pub(crate) fn gauss(panels: u32) -> Vec<(f64, f64)> {
    let width = 1.0 / f64::from(panels.max(1));
    let panel = |panel| {
        let middle = (f64::from(panel) + 0.5) * width;
        let below = HALF.iter().rev().map(|(node, weight)| (-node, *weight));
        below.chain(HALF).map(move |(node, weight)| {
            let half = 0.5 * width;
            (middle + half * node, half * weight)
        })
    };
    (0..panels).flat_map(panel).collect()
}

#[cfg(test)]
mod tests {
    use super::gauss;

    #[test]
    fn powers_are_integrated_up_to_the_eleventh() {
        for panels in 1..4 {
            for power in 0..12 {
                let sum: f64 = gauss(panels).iter().map(|(x, w)| w * x.powi(power)).sum();
                let exact = 1.0 / f64::from(power + 1);
                assert!((sum - exact).abs() < 1e-15, "{panels} {power}: {sum}");
            }
        }
        let twelfth: f64 = gauss(1).iter().map(|(x, w)| w * x.powi(12)).sum();
        assert!((twelfth - 1.0 / 13.0).abs() > 1e-9);
    }
}

//! Where a smooth function is at zero, from three points on one side of it.

/// The value at zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Extrapolated {
    /// By the parabola through all three points.
    pub(crate) value: f64,
    /// By the line through the two that are nearest to zero, and by the one through the others.
    pub(crate) lines: [f64; 2],
}

/// The value at zero of the line through two points (x, value); not finite where they are one.
pub(crate) fn line((x, p): (f64, f64), (y, q): (f64, f64)) -> f64 {
    (x * q - y * p) / (x - y)
}

/// Neville's scheme for points (x, value), the nearest to zero last; not finite where two of them are one.
pub(crate) fn at_zero([far, middle, near]: [(f64, f64); 3]) -> Extrapolated {
    let lines = [line(middle, near), line(far, middle)];
    Extrapolated {
        value: line((far.0, lines[1]), (near.0, lines[0])),
        lines,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parabolas_are_continued_exactly() {
        let value = |x: f64| 2.0 - x + 3.0 * x * x;
        let found = at_zero([4.0, 2.0, 1.0].map(|x| (x, value(x))));
        assert!((found.value - 2.0).abs() < 1e-13);
        // A line through x and y misses it by −3 x y.
        assert_eq!(found.lines, [2.0 - 6.0, 2.0 - 24.0]);
    }
}

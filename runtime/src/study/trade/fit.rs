//! Straight lines in double logarithmic scales.

use serde::Serialize;

/// e = b ε^a.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Fit {
    /// The exponent.
    pub a: f64,
    /// The factor.
    pub b: f64,
}

impl Fit {
    /// The least-squares line through (ln ε, ln |e|); `None` with fewer than two points off zero.
    #[must_use]
    pub fn through(points: impl IntoIterator<Item = (f64, f64)>) -> Option<Self> {
        let logs: Vec<(f64, f64)> = points
            .into_iter()
            .map(|(size, error)| (size.ln(), error.abs().ln()))
            .filter(|(x, y)| x.is_finite() && y.is_finite())
            .collect();
        let count = logs.len() as f64;
        let mean = |of: fn(&(f64, f64)) -> f64| logs.iter().map(of).sum::<f64>() / count;
        let (x, y) = (mean(|p| p.0), mean(|p| p.1));
        let spread: f64 = logs.iter().map(|p| (p.0 - x).powi(2)).sum();
        let common: f64 = logs.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
        let a = common / spread;
        (logs.len() > 1 && a.is_finite()).then(|| Self {
            a,
            b: (y - a * x).exp(),
        })
    }

    /// The size at which the line meets this error.
    #[must_use]
    pub fn size(&self, error: f64) -> f64 {
        (error / self.b).powf(1.0 / self.a)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_power_is_found_again() {
        let fit = Fit::through([1e2, 1e3, 1e5].map(|x: f64| (x, -3.0 * x.powf(-0.6)))).unwrap();
        assert!((fit.a + 0.6).abs() < 1e-14 && (fit.b - 3.0).abs() < 1e-13);
        assert!((fit.size(3.0 * 1e4_f64.powf(-0.6)) / 1e4 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn one_point_has_no_slope() {
        assert_eq!(Fit::through([(1.0, 1.0)]), None);
        assert_eq!(Fit::through([(1.0, 1.0), (2.0, 0.0)]), None);
    }
}

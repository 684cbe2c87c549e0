//! A safeguarded secant.

/// Brackets this narrow are not worth another evaluation.
const NARROW: f64 = 1e-14;
const TRIALS: usize = 80;

/// Follows the sign change of a test function over the shares 0 to 1 of a step (Illinois), and shows `try_at` each
/// share tried; `try_at` gives the test there, or `None` where it cannot be had.
pub(crate) fn root(at_0: f64, at_1: f64, mut try_at: impl FnMut(f64) -> Option<f64>) {
    let (mut low, mut high) = ((0.0, at_0), (1.0, at_1));
    let (mut last, mut side) = (f64::NAN, 0);
    for _ in 0..TRIALS {
        let width = high.0 - low.0;
        let secant = low.0 + width * low.1 / (low.1 - high.1);
        let middle = low.0 + 0.5 * width;
        let inside = secant > low.0 && secant < high.0;
        let first = if inside { secant } else { middle };
        let Some((share, test)) = try_at(first)
            .map(|test| (first, test))
            .or_else(|| try_at(middle).map(|test| (middle, test)))
        else {
            return;
        };
        if test == 0.0 || width <= NARROW || (share - last).abs() <= NARROW {
            return;
        }
        last = share;
        // An end that stays put twice counts half, so that the secant cannot lean on it for ever.
        if (test >= 0.0) == (at_0 >= 0.0) {
            low = (share, test);
            high.1 *= if side == 1 { 0.5 } else { 1.0 };
            side = 1;
        } else {
            high = (share, test);
            low.1 *= if side == -1 { 0.5 } else { 1.0 };
            side = -1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{NARROW, root};

    #[test]
    fn a_root_is_found_to_the_narrowest_bracket() {
        let (mut best, mut trials) = (0.0, 0);
        let test = |x: f64| (x - 0.3).exp() - 1.0 + (x - 0.3).powi(3);
        root(test(0.0), test(1.0), |x| {
            best = x;
            trials += 1;
            Some(test(x))
        });
        assert!((best - 0.3_f64).abs() < NARROW, "{best}");
        assert!(trials < 40, "{trials}");
    }
}

use super::*;
use crate::integrate::Dense;

/// The dense output of θᵏ errs by nothing up to degree 7, and from there on by its eighth derivative.
#[test]
fn the_dense_output_is_that_of_each_power() {
    for k in 1..=DEGREE {
        let mut terms = [[0.0]; DEGREE + 1];
        terms[k] = [1.0];
        let series = Series {
            terms,
            degree: DEGREE,
        };
        let dense = Dense::of_terms([0.0], 1.0, series.path());
        for i in 0..=20 {
            let theta = f64::from(i) / 20.0;
            let off = dense.state(theta)[0] - series.state(theta)[0];
            // f⁽⁸⁾/8! of θᵏ is C(k, 8) at most.
            let choices: f64 = (1..=8)
                .map(|i| (k as f64 - 8.0) / f64::from(i) + 1.0)
                .product();
            let bound = if k < 8 { 0.0 } else { 3.01e-4 * choices };
            assert!(off.abs() <= bound + 1e-12, "{k} {theta}: {off}");
        }
        for theta in [0.0, MEETING, 1.0 - MEETING, 1.0] {
            let off = dense.state(theta)[0] - series.state(theta)[0];
            assert!(off.abs() < 1e-12, "{k} {theta}: {off}");
        }
    }
}

#[test]
fn degrees_suffice() {
    for reach in [0.0, 0.1, 0.5, 1.0, 1.4] {
        let degree = degree(reach);
        let last: f64 = (1..degree).map(|k| reach / k as f64).product();
        assert!(
            (FEWEST..=DEGREE).contains(&degree) && last < 1e-17,
            "{reach} {degree}"
        );
    }
}

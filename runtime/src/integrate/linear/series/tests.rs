use super::*;
use crate::integrate::Dense;

/// What the dense output of θᵏ errs by is Σ over its divided difference: nothing up to degree 7.
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
            let bound = match k {
                ..=7 => 1e-13,
                8 => 3.01e-4,
                _ => 0.1,
            };
            assert!(off.abs() <= bound, "{k} {theta}: {off}");
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

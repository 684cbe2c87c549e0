//! The derivatives of the formulas that are written by hand.

use stickslip_tests::hand_written::{
    Linearised, belt_oscillator, belt_pair, drill_string, van_der_pol,
};

/// Central differences of f agree with the derivatives that are written out.
fn assert_consistent<const N: usize, const P: usize>(
    evaluate: impl Fn([f64; P], [f64; N]) -> Linearised<N, P>,
    parameters: [f64; P],
    state: [f64; N],
) {
    let step = 1e-6;
    let exact = evaluate(parameters, state);
    for j in 0..N {
        let shifted = |by: f64| {
            let mut shifted = state;
            shifted[j] += by;
            evaluate(parameters, shifted).f
        };
        let (up, down) = (shifted(step), shifted(-step));
        for i in 0..N {
            let slope = (up[i] - down[i]) / (2.0 * step);
            assert!((slope - exact.jacobian[i][j]).abs() < 1e-7, "∂f{i}/∂x{j}");
        }
    }
    for p in 0..P {
        let shifted = |by: f64| {
            let mut shifted = parameters;
            shifted[p] += by;
            evaluate(shifted, state).f
        };
        let (up, down) = (shifted(step), shifted(-step));
        for i in 0..N {
            let slope = (up[i] - down[i]) / (2.0 * step);
            assert!(
                (slope - exact.by_parameter[p][i]).abs() < 1e-7,
                "∂f{i}/∂p{p}"
            );
        }
    }
}

#[test]
fn derivatives_are_slopes() {
    assert_consistent(van_der_pol, [1.3], [0.7, -0.4]);
    let eps = 5.0;
    assert_consistent(
        |p, x| belt_oscillator(p, eps, x),
        [1.5, 0.8, 0.2, 1.1, 3.0],
        [0.7, -0.4],
    );
    assert_consistent(
        |p, x| belt_pair(p, eps, x),
        [1.2, 1.3, 3.0, 0.1],
        [-0.6, 0.3, -0.5, -0.2],
    );
    for omega in [3.9, 3.0, 2.1, 1.0] {
        assert_consistent(
            |p, x| drill_string(p, 0.6, x),
            [4.0, 4.2, 3.0, 0.05],
            [5.0, omega],
        );
    }
}

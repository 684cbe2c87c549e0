//! Coefficients of the Radau IIA collocation methods.
//!
//! Nodes are the zeros of P_S − P_{S−1} on [0, 1]; A integrates the Lagrange polynomials; the error
//! weights are those of Hairer & Wanner, Solving ODEs II, section IV.8. Computed from these
//! definitions with 60 digits and rounded; the tests check the defining conditions.

/// A Radau IIA method with `S` stages: order 2S − 1, L-stable, stiffly accurate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tableau<const S: usize> {
    /// Nodes; the last is 1.
    pub nodes: [f64; S],
    /// Runge-Kutta matrix; its last row is the quadrature.
    pub matrix: [[f64; S]; S],
    /// Weight of h f(y₀) in the embedded formula of order S: the inverse of the real eigenvalue of A⁻¹.
    pub gamma: f64,
    /// Weights of the stage increments in the error of the embedded formula.
    pub error: [f64; S],
}

/// Radau IIA with 3 stages, order 5.
pub const RADAU_3: Tableau<3> = Tableau {
    nodes: [0.1550510257216822, 0.6449489742783178, 1.0],
    matrix: [
        [
            0.1968154772236604,
            -0.06553542585019839,
            0.02377097434822015,
        ],
        [0.3944243147390873, 0.2920734116652285, -0.04154875212599793],
        [0.37640306270046725, 0.5124858261884216, 0.1111111111111111],
    ],
    gamma: 0.27488882959567734,
    error: [-2.7623054547485992, 0.3799355982527289, -0.0916296098652258],
};

/// Radau IIA with 5 stages, order 9.
pub const RADAU_5: Tableau<5> = Tableau {
    nodes: [
        0.05710419611451768,
        0.2768430136381238,
        0.5835904323689168,
        0.8602401356562195,
        1.0,
    ],
    matrix: [
        [
            0.07299886431790333,
            -0.02673533110794557,
            0.018676929763984353,
            -0.01287910609330644,
            0.005042839233882015,
        ],
        [
            0.15377523147918246,
            0.14621486784749352,
            -0.03644456890512809,
            0.02123306311930472,
            -0.007935579902728777,
        ],
        [
            0.14006304568480987,
            0.29896712949128346,
            0.16758507013524895,
            -0.03396910168661774,
            0.010944288744192253,
        ],
        [
            0.14489430810953477,
            0.2765000687601592,
            0.32579792291042103,
            0.12875675325490976,
            -0.015708917378805327,
        ],
        [
            0.14371356079122594,
            0.28135601514946207,
            0.31182652297574126,
            0.22310390108357075,
            0.04,
        ],
    ],
    gamma: 0.15906584442746913,
    error: [
        -4.418997716796381,
        0.57923485225667,
        -0.199237560953468,
        0.09416748369194548,
        -0.03181316888549383,
    ],
};

#[cfg(test)]
mod tests {
    use super::*;

    /// C(S): A cᵏ⁻¹ = cᵏ/k for k ≤ S, and B(2S − 1): b cᵏ⁻¹ = 1/k for k ≤ 2S − 1.
    fn assert_collocation<const S: usize>(tableau: &Tableau<S>) {
        let moment = |row: &[f64; S], k: i32| -> f64 {
            (0..S).map(|j| row[j] * tableau.nodes[j].powi(k - 1)).sum()
        };
        for k in 1..=S as i32 {
            for (row, node) in tableau.matrix.iter().zip(tableau.nodes) {
                assert!(
                    (moment(row, k) - node.powi(k) / f64::from(k)).abs() < 4e-16,
                    "C({k})"
                );
            }
        }
        for k in 1..2 * S as i32 {
            assert!(
                (moment(&tableau.matrix[S - 1], k) - 1.0 / f64::from(k)).abs() < 2e-16,
                "B({k})"
            );
        }
    }

    /// The embedded formula integrates polynomials of degree < S exactly, so its error vanishes there.
    fn assert_embedded<const S: usize>(tableau: &Tableau<S>) {
        for k in 1..=S as i32 {
            let increments = tableau.nodes.map(|node| node.powi(k) / f64::from(k));
            let first = if k == 1 { tableau.gamma } else { 0.0 };
            let error: f64 = first
                + (0..S)
                    .map(|i| tableau.error[i] * increments[i])
                    .sum::<f64>();
            assert!(error.abs() < 2e-15, "degree {k}: {error:e}");
        }
    }

    #[test]
    fn three_stages_meet_their_definition() {
        assert_collocation(&RADAU_3);
        assert_embedded(&RADAU_3);
    }

    #[test]
    fn five_stages_meet_their_definition() {
        assert_collocation(&RADAU_5);
        assert_embedded(&RADAU_5);
    }
}

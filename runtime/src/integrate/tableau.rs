//! Coefficients of the Radau IIA collocation methods.
//!
//! Nodes are the zeros of P_S − P_{S−1} on [0, 1]; A integrates the Lagrange polynomials; the error
//! weights are those of Hairer & Wanner, Solving ODEs II, section IV.8. Computed from these
//! definitions with 60 digits; the tests check the defining conditions.

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
    nodes: [0.15505102572168219018, 0.64494897427831780982, 1.0],
    matrix: [
        [
            0.19681547722366042587,
            -0.065535425850198388109,
            0.02377097434822015242,
        ],
        [
            0.394424314739087277,
            0.29207341166522846302,
            -0.041548752125997930198,
        ],
        [
            0.37640306270046727505,
            0.51248582618842161384,
            0.11111111111111111111,
        ],
    ],
    gamma: 0.27488882959567736775,
    error: [
        -2.7623054547485993983,
        0.37993559825272887787,
        -0.091629609865225789249,
    ],
};

/// Radau IIA with 5 stages, order 9.
pub const RADAU_5: Tableau<5> = Tableau {
    nodes: [
        0.057104196114517682193,
        0.27684301363812382768,
        0.58359043236891682006,
        0.86024013565621944785,
        1.0,
    ],
    matrix: [
        [
            0.072998864317903324306,
            -0.026735331107945571878,
            0.018676929763984354412,
            -0.012879106093306439854,
            0.0050428392338820152067,
        ],
        [
            0.15377523147918246867,
            0.14621486784749350665,
            -0.036444568905128089527,
            0.021233063119304719422,
            -0.0079355799027287775326,
        ],
        [
            0.14006304568480987151,
            0.2989671294912834794,
            0.16758507013524896344,
            -0.033969101686617746572,
            0.010944288744192252274,
        ],
        [
            0.14489430810953475754,
            0.27650006876015922756,
            0.32579792291042102998,
            0.12875675325490976116,
            -0.015708917378805328388,
        ],
        [
            0.14371356079122594132,
            0.28135601514946206019,
            0.31182652297574125408,
            0.2231039010835707444,
            0.04,
        ],
    ],
    gamma: 0.15906584442746912048,
    error: [
        -4.4189977167963817226,
        0.57923485225667005447,
        -0.19923756095346800874,
        0.094167483691945488975,
        -0.031813168885493824096,
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

use super::*;

#[test]
fn a_normal_matrix_has_conditions_of_one_and_a_defective_one_of_a_root_of_rounding() {
    let turn = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -1.0, 0.0]);
    for found in eigenvalues(&turn) {
        assert!((found.condition - 1.0).abs() < 1e-12, "{found:?}");
        assert!(found.error(0.0) < 1e-13, "{found:?}");
    }
    // λ² = −1 twice, with one vector only.
    let rows = [
        0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, -1.0, 1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0,
    ];
    for found in eigenvalues(&DMatrix::from_row_slice(4, 4, &rows)) {
        let off = (found.value.re).hypot(found.value.im.abs() - 1.0);
        assert!(off <= found.error(0.0), "{off:e}: {found:?}");
        assert!(found.error(0.0) < 1e-5, "{found:?}");
    }
}

#[test]
fn equal_eigenvalues_with_one_vector_are_known_to_a_root_of_rounding() {
    // (λ + 1)² exactly, as of critical damping; (λ − 2)³; (λ + 1)⁴ turned, so that rounding parts them.
    let chain = |order: usize, value: f64| {
        DMatrix::from_fn(order, order, |i, j| match () {
            () if i == j => value,
            () if j == i + 1 => 1.0,
            () => 0.0,
        })
    };
    let turn = DMatrix::from_fn(4, 4, |i, j| ((i * j + i + 2 * j) as f64).sin());
    let turn = turn.qr().q();
    let damped = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -1.0, -2.0]);
    let turned = turn.transpose() * chain(4, -1.0) * &turn;
    for (matrix, value, most) in [
        (damped, -1.0, 1e-6),
        (chain(3, 2.0), 2.0, 1e-4),
        (turned, -1.0, 1e-2),
    ] {
        for found in eigenvalues(&matrix) {
            let off = (found.value - Complex::new(value, 0.0)).norm();
            let error = found.error(f64::EPSILON);
            assert!(off <= error && error < most, "{off:e}: {found:?}");
        }
    }
}

#[test]
fn eigenvalues_that_lie_symmetrically_about_zero_are_found() {
    // Two masses without damping that flutter: λ⁴ + 31 λ² + 220 − c d = 0.
    for step in 0..200 {
        let product = -20.25 - 0.1 * f64::from(step + 1);
        let [first, second] = [2.5, product / 2.5];
        let rows = [
            0.0, 1.0, 0.0, 0.0, -11.0, 0.0, -second, 0.0, 0.0, 0.0, 0.0, 1.0, -first, 0.0, -20.0,
            0.0,
        ];
        let found = eigenvalues(&DMatrix::from_row_slice(4, 4, &rows));
        let square = Complex::new(-15.5, (-20.25 - product).sqrt());
        for one in found {
            let off = [square, square.conj()].map(|square| (one.value * one.value - square).norm());
            let most = 2.1 * one.value.norm() * one.error(f64::EPSILON);
            assert!(off[0].min(off[1]) <= most, "{product}: {one:?}");
            assert!(one.error(f64::EPSILON) < 1e-11, "{one:?}");
        }
    }
}

#[test]
fn eigenvalues_that_are_not_found_lie_within_the_size_of_the_matrix() {
    let turn = DMatrix::from_row_slice(2, 2, &[0.0, 3.0, -4.0, 0.0]);
    let found = within(&turn);
    assert_eq!(found.len(), 2);
    assert!(found.iter().all(|one| one.error(0.0) >= 12.0_f64.sqrt()));
}

#[test]
fn errors_lie_below_their_bounds_whatever_the_units() {
    // Companion matrices of polynomials whose roots are known, in units from 1e-6 to 1e6.
    for (roots, unit) in [([-1.0, -2.0, -3.0], 1e6), ([-1.0, 1e-3, 40.0], 1e-6)] {
        let [a, b, c]: [f64; 3] = roots;
        let last = [a * b * c, -(a * b + b * c + c * a), a + b + c];
        let rows = [
            0.0,
            unit,
            0.0,
            0.0,
            0.0,
            1.0 / unit,
            last[0],
            last[1] * unit,
            last[2],
        ];
        for found in eigenvalues(&DMatrix::from_row_slice(3, 3, &rows)) {
            let off = roots.map(|root| (found.value - root).norm());
            let off = off.into_iter().fold(f64::INFINITY, f64::min);
            assert!(off <= found.error(f64::EPSILON), "{off:e}: {found:?}");
            assert!(found.error(f64::EPSILON) < 1e-10, "{found:?}");
        }
    }
}

#[test]
fn real_and_complex_eigenvalues_stand_beside_each_other() {
    let rows = [
        0.1, -2.0, 0.3, 1.0, 2.0, 0.1, 0.5, 0.0, 0.0, 0.0, 1.0, 0.3, 0.0, 0.0, 0.0, -3.0,
    ];
    let mut found: Vec<_> = eigenvalues(&DMatrix::from_row_slice(4, 4, &rows));
    found.sort_by(|a, b| {
        (a.value.re, a.value.im)
            .partial_cmp(&(b.value.re, b.value.im))
            .unwrap()
    });
    let expected = [(-3.0, 0.0), (0.1, -2.0), (0.1, 2.0), (1.0, 0.0)];
    for (found, (re, im)) in found.iter().zip(expected) {
        assert!((found.value - Complex::new(re, im)).norm() <= found.error(f64::EPSILON));
    }
}

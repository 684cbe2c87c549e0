use fastrand::Rng;

use super::*;

/// The polynomial of degree 7 with these roots, positive just after 0, through its values.
fn with_roots(roots: &[f64], factor: impl Fn(f64) -> f64) -> Bernstein {
    let sign = if roots.iter().filter(|r| **r > 0.0).count() % 2 == 0 {
        1.0
    } else {
        -1.0
    };
    let value = |x: f64| sign * factor(x) * roots.iter().map(|r| x - r).product::<f64>();
    Bernstein::interpolate(&Bernstein::nodes().map(value))
}

#[test]
fn interpolation_reproduces_polynomials() {
    let p = Bernstein::new(&[1.0, -2.0, 0.5, 3.0, -1.0, 0.25, 2.0, -0.5]);
    let q = Bernstein::interpolate(&Bernstein::nodes().map(|x| p.value(x)));
    for (a, b) in p.coefficients().iter().zip(q.coefficients()) {
        assert!((a - b).abs() < 1e-12, "{a} {b}");
    }
}

#[test]
fn derivative_is_the_slope() {
    let p = Bernstein::new(&[1.0, -2.0, 0.5, 3.0, -1.0, 0.25, 2.0, -0.5]);
    for theta in [0.0, 0.2, 0.63, 1.0] {
        let (value, slope) = p.value_and_slope(theta);
        assert!((value - p.value(theta)).abs() < 1e-15);
        assert!((slope - p.derivative().value(theta)).abs() < 1e-13);
    }
}

#[test]
fn no_root_of_random_polynomials_is_missed() {
    let mut random = Rng::with_seed(1);
    for _ in 0..20_000 {
        let coefficients: [f64; 8] = crate::scalar::filled(|_| random.f64() - 0.4);
        let p = Bernstein::new(&coefficients);
        let found: Vec<_> = p.sign_changes().iter().copied().collect();
        // Between neighbouring sign changes, a fine grid shows the sign that they announce.
        let mut sign = coefficients[0].signum();
        let mut from = 0.0;
        for change in found.iter().chain([&SignChange {
            theta: 1.0,
            rising: sign < 0.0,
        }]) {
            for k in 1..40 {
                let theta = from + (change.theta - from) * f64::from(k) / 40.0;
                assert!(
                    p.value(theta) * sign > -1e-14,
                    "{coefficients:?} at {theta}"
                );
            }
            from = change.theta;
            sign = if change.rising { 1.0 } else { -1.0 };
        }
    }
}

#[test]
fn roots_are_accurate() {
    let mut random = Rng::with_seed(2);
    for _ in 0..2000 {
        let mut roots: Vec<f64> = (0..5).map(|_| 1.6 * random.f64() - 0.3).collect();
        roots.sort_by(f64::total_cmp);
        if roots.windows(2).any(|w| w[1] - w[0] < 0.02) {
            continue;
        }
        let p = with_roots(&roots, |x| 1.0 + x * x);
        let inside: Vec<f64> = roots
            .into_iter()
            .filter(|r| (0.0..1.0).contains(r))
            .collect();
        let found: Vec<f64> = p.sign_changes().iter().map(|c| c.theta).collect();
        assert_eq!(found.len(), inside.len(), "{found:?} {inside:?}");
        for (a, b) in found.iter().zip(&inside) {
            assert!((a - b).abs() < 1e-9, "{a} {b}");
        }
        assert_eq!(p.first_fall().is_some(), !inside.is_empty());
    }
}

#[test]
fn a_double_root_is_no_sign_change_and_a_near_graze_two() {
    for middle in [0.5, 0.3, 0.71234] {
        let touch = |gap: f64| {
            Bernstein::interpolate(
                &Bernstein::nodes().map(|x| (1.0 + x) * ((x - middle).powi(2) + gap)),
            )
        };
        assert_eq!(touch(1e-12).first_fall(), None);
        let (fall, until) = touch(-1e-10).first_fall().unwrap();
        assert!((until - middle).abs() < 1e-7, "{until}");
        assert!((fall - (middle - 1e-5)).abs() < 1e-7, "{fall}");
        assert_eq!(touch(-1e-10).sign_changes().iter().count(), 2);
    }
}

#[test]
fn roots_at_both_ends_and_at_the_seam() {
    let p = Bernstein::new(&[0.0, 1.0, 1.0, 0.0]);
    assert_eq!(p.first_fall(), None);
    let p = Bernstein::new(&[0.0, 1.0, -1.0, 0.0]);
    assert_eq!(p.first_fall(), Some((0.5, 1.0)));
    // The root at an end is not the one between.
    let p = Bernstein::new(&[0.0, 0.3, -0.4]);
    let (fall, _) = p.first_fall().unwrap();
    assert!((fall - 0.6).abs() < 1e-12, "{fall}");
    let p = with_roots(&[0.1, 0.5, 0.9], |_| 1.0);
    let found: Vec<f64> = p.sign_changes().iter().map(|c| c.theta).collect();
    assert_eq!(found.len(), 3, "{found:?}");
    assert!((found[1] - 0.5).abs() < 1e-12);
}

#[test]
fn deflation_removes_the_roots_at_a_departure() {
    // θ² (0.6 − θ): tangential departure and a return; the two lowest coefficients carry only noise.
    let mut p = Bernstein::interpolate(&Bernstein::nodes().map(|x| x * x * (0.6 - x)));
    p.coefficients[0] = -1e-17;
    p.coefficients[1] = -1e-17;
    assert!(
        p.first_fall().is_some_and(|(theta, _)| theta < 1e-7),
        "noise hides the return"
    );
    let (fall, _) = p.deflated(2).first_fall().unwrap();
    assert!((fall - 0.6).abs() < 1e-13, "{fall}");
    assert_eq!(p.deflated(2).coefficients().len(), 6);
}

#[test]
fn polishing_is_safe_and_sharp() {
    let root = polish(0.0, 2.0, 1.9, |x| (1.0 - x.powi(9), -9.0 * x.powi(8)));
    assert!((root - 1.0).abs() < 1e-15, "{root}");
    let lying_slope = polish(0.0, 1.0, 0.5, |x| (0.3 - x, 1.0));
    assert!((lying_slope - 0.3).abs() < 1e-15, "{lying_slope}");
    let flat = polish(0.0, 1.0, 0.5, |x| {
        ((0.4 - x).powi(3), -3.0 * (0.4 - x).powi(2))
    });
    assert!((flat - 0.4).abs() < 1e-7, "{flat}");
}

/// Each half of such a polynomial varies as much as the whole: a search that goes by that never ends.
#[test]
fn what_is_no_number_has_no_roots() {
    for hole in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for place in 0..8 {
            let mut coefficients = [1.0, -2.0, 0.5, 3.0, -1.0, 0.25, 2.0, -0.5];
            coefficients[place] = hole;
            let p = Bernstein::new(&coefficients);
            assert!(p.sign_changes().iter().count() <= 7);
            let _ = p.first_fall();
        }
    }
}

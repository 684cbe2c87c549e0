use fastrand::Rng;

use super::Interval;

/// A function of intervals, of numbers, and the range in which both are tried.
type Case = (
    &'static str,
    fn(Interval) -> Interval,
    fn(f64) -> f64,
    [f64; 2],
);

const CASES: [Case; 21] = [
    ("abs", Interval::abs, f64::abs, [-3.0, 3.0]),
    ("sqrt", Interval::sqrt, f64::sqrt, [0.0, 9.0]),
    ("cbrt", Interval::cbrt, f64::cbrt, [-9.0, 9.0]),
    ("exp", Interval::exp, f64::exp, [-20.0, 20.0]),
    ("exp_m1", Interval::exp_m1, f64::exp_m1, [-3.0, 3.0]),
    ("ln", Interval::ln, f64::ln, [1e-9, 9.0]),
    ("ln_1p", Interval::ln_1p, f64::ln_1p, [-0.9, 9.0]),
    ("powf", |x| x.powf(-1.7), |x| x.powf(-1.7), [0.1, 9.0]),
    ("powi", |x| x.powi(3), |x| x * x * x, [-2.0, 2.0]),
    ("square", |x| x.powi(2), |x| x * x, [-2.0, 2.0]),
    ("sin", Interval::sin, f64::sin, [-20.0, 20.0]),
    ("cos", Interval::cos, f64::cos, [-20.0, 20.0]),
    ("tan", Interval::tan, f64::tan, [-1.5, 1.5]),
    ("atan", Interval::atan, f64::atan, [-9.0, 9.0]),
    ("asin", Interval::asin, f64::asin, [-1.0, 1.0]),
    ("acos", Interval::acos, f64::acos, [-1.0, 1.0]),
    ("cosh", Interval::cosh, f64::cosh, [-5.0, 5.0]),
    ("tanh", Interval::tanh, f64::tanh, [-30.0, 30.0]),
    ("asinh", Interval::asinh, f64::asinh, [-9.0, 9.0]),
    ("acosh", Interval::acosh, f64::acosh, [1.0, 9.0]),
    ("atanh", Interval::atanh, f64::atanh, [-0.99, 0.99]),
];

/// Every value on an interval lies in the function of the interval, which is hardly wider than the values are.
#[test]
fn functions_enclose_their_values_tightly() {
    let mut random = Rng::with_seed(1);
    for (name, enclose, function, [from, to]) in CASES {
        for _ in 0..200 {
            let ends = [(); 2].map(|()| from + (to - from) * random.f64());
            let x = Interval::new(ends[0].min(ends[1]), ends[0].max(ends[1]));
            let y = enclose(x);
            let values: Vec<f64> = (0..=2000)
                .map(|i| x.low() + (x.high() - x.low()) * (f64::from(i) / 2000.0))
                .map(|at| function(at.clamp(x.low(), x.high())))
                .collect();
            assert!(values.iter().all(|&v| y.contains(v)), "{name} {x:?} {y:?}");
            let least = values.iter().copied().fold(f64::INFINITY, f64::min);
            let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            // What lies between the samples.
            let spare = 2e-3 * (1.0 + y.magnitude());
            assert!(
                y.low() > least - spare && y.high() < most + spare,
                "{name} {x:?}: {y:?} is wide for {least} to {most}"
            );
        }
    }
}

/// Sums, products and quotients of integers are known exactly: they lie strictly between the ends unless trivial.
#[test]
fn arithmetic_encloses_what_is_exact() {
    let mut random = Rng::with_seed(1);
    for _ in 0..2000 {
        let [a, b, c, d] = [(); 4].map(|()| (40.0 * random.f64()).floor() - 20.0);
        let (x, y) = (
            Interval::new(a.min(b), a.max(b)),
            Interval::new(c.min(d), c.max(d)),
        );
        for (p, q) in [(a, c), (a, d), (b, c), (b, d)] {
            assert!((x + y).contains(p + q) && (x - y).contains(p - q) && (x * y).contains(p * q));
            assert!(q == 0.0 || (x / y).contains(p / q));
        }
    }
    let third = Interval::ONE / Interval::from(3.0);
    assert!(third.low() < third.high());
    assert!((third * Interval::from(3.0) - Interval::ONE).contains(0.0));
}

/// 0.1 + 0.2 as doubles is not 0.3 as a double; all three lie where they should.
#[test]
fn rounding_is_outwards() {
    let sum = Interval::from(0.1) + Interval::from(0.2);
    assert!(sum.contains(0.3) && sum.contains(0.1 + 0.2) && sum.low() < sum.high());
    let tiny = Interval::from(1e-200) * Interval::from(1e-200);
    assert!(tiny.contains(f64::from_bits(1)) && tiny.high() > 0.0);
    let huge = Interval::from(1e200) * Interval::from(1e200);
    assert!(huge.low().is_finite() && huge.high() == f64::INFINITY);
}

#[test]
fn what_is_undefined_is_unknown() {
    let across = Interval::new(-1.0, 1.0);
    for unknown in [
        Interval::ONE / across,
        across.sqrt(),
        across.ln(),
        across.powf(0.5),
        Interval::new(1.0, 2.0).tan(),
        Interval::new(0.5, 1.5).asin(),
        Interval::from(f64::NAN),
        Interval::new(1.0, -1.0),
        Interval::ENTIRE - Interval::ENTIRE,
    ] {
        assert_eq!(unknown, Interval::ENTIRE);
    }
    assert_eq!(Interval::ENTIRE * Interval::ZERO, Interval::ZERO);
}

/// sin turns at its maximum, and not anywhere near an interval that misses it.
#[test]
fn turning_points_are_seen() {
    assert_eq!(Interval::new(1.5, 1.6).sin().high(), 1.0);
    assert_eq!(Interval::new(4.0, 5.0).sin().low(), -1.0);
    assert!(Interval::new(1.0, 1.5).sin().high() < 0.998);
    assert_eq!(Interval::new(-0.1, 0.1).cos().high(), 1.0);
    assert_eq!(Interval::new(0.0, 7.0).cos(), Interval::new(-1.0, 1.0));
}

use num_dual::{Dual64, DualNum};

use super::Enclosure;
use crate::math;
use crate::math::interval::Interval;
use crate::scalar::Scalar;

/// A formula over any number, and a place where all of it is defined.
trait Formula {
    fn at<D: Scalar>(&self, x: D) -> D;
}

struct Everything;

impl Formula for Everything {
    fn at<D: Scalar>(&self, x: D) -> D {
        let y = math::exp(math::sin(x)) / (x + 2.0) - math::cos(x) * math::powi(x, 3);
        let z = math::tanh(y) + math::atan(y * 3.0) - math::sqrt(x * x + 1.0);
        let w = math::ln(x + 3.0) + math::power(x, 1.5) + math::powf(x, x) + math::cosh(x);
        let u = math::tan(x) - math::asin(x) * math::acos(x) + math::sinh(x) - math::asinh(x);
        z * w + u / math::acosh(x + 1.5) - math::atanh(x) * 0.25
    }
}

/// Value and derivative at every place of a box lie in those over the box, and a small box says little more.
#[test]
fn a_formula_is_enclosed_with_its_derivative() {
    for (from, to) in [(0.3, 0.3), (0.3, 0.31), (0.1, 0.9)] {
        let over = Everything.at(Enclosure::<1>::coordinate(Interval::new(from, to), 0));
        for i in 0..=100 {
            let x = (from + (to - from) * f64::from(i) / 100.0).min(to);
            let at = Everything.at(Dual64::new(x, 1.0));
            assert!(over.value.contains(at.re), "{x}: {} {over}", at.re);
            assert!(over.slopes[0].contains(at.eps), "{x}: {} {over:?}", at.eps);
        }
        let width = over.slopes[0].high() - over.slopes[0].low();
        assert!(width < 1e-10 + 600.0 * (to - from) / (1.0 - to), "{width}");
    }
}

#[test]
fn functions_that_no_formula_has_are_right_as_well() {
    type Function = (fn(Enclosure<1>) -> Enclosure<1>, fn(Dual64) -> Dual64);
    let cases: [Function; 9] = [
        (|x| x.cbrt(), |x| x.cbrt()),
        (|x| x.exp_m1(), |x| x.exp_m1()),
        (|x| x.ln_1p(), |x| x.ln_1p()),
        (|x| x.exp2(), |x| x.exp2()),
        (|x| x.log10(), |x| x.log10()),
        (|x| DualNum::powi(&x, -3), |x| DualNum::powi(&x, -3)),
        (|x| x.recip(), |x| x.recip()),
        (|x| x.sin_cos().1, |x| x.sin_cos().1),
        (|x| x - x * 2.0 / 3.0, |x| x - x * 2.0 / 3.0),
    ];
    for (k, (enclose, function)) in cases.into_iter().enumerate() {
        let (found, right) = (
            enclose(Enclosure::coordinate(Interval::from(0.7), 0)),
            function(Dual64::new(0.7, 1.0)),
        );
        let wide =
            |x: Interval| Interval::around(x.middle(), x.magnitude() * 1e-15 + x.high() - x.low());
        assert!(wide(found.value).contains(right.re), "{k}: {found} {right}");
        assert!(
            wide(found.slopes[0]).contains(right.eps),
            "{k}: {found:?} {right}"
        );
        assert!(
            found.value.high() - found.value.low() < 1e-13,
            "{k}: {found}"
        );
    }
}

/// At a kink the derivatives of both sides are there; beyond it only one is.
#[test]
fn kinks_have_the_derivatives_of_both_sides() {
    let over = |from, to| Enclosure::<1>::coordinate(Interval::new(from, to), 0);
    let slope = |of: Enclosure<1>| of.slopes[0];
    assert_eq!(slope(over(-0.1, 0.2).magnitude()), Interval::new(-1.0, 1.0));
    assert_eq!(slope(over(-0.2, -0.1).magnitude()), Interval::from(-1.0));
    let clamped = over(0.5, 2.0).clamped(-1.0, 1.0);
    assert_eq!(
        (clamped.value, slope(clamped)),
        (Interval::new(0.5, 1.0), Interval::new(0.0, 1.0))
    );
    assert_eq!(slope(over(1.5, 2.0).clamped(-1.0, 1.0)), Interval::ZERO);
    assert_eq!(slope(over(-0.5, 0.5).clamped(-1.0, 1.0)), Interval::ONE);
}

/// No comparison holds that does not hold for all values.
#[test]
fn a_box_has_no_single_value() {
    let x = Enclosure::<1>::coordinate(Interval::new(-1.0, 1.0), 0);
    assert!(num_dual::DualStruct::re(&x).is_nan());
    let unknown = [x < 0.5, x > 0.5, x == 0.0];
    assert_eq!(unknown, [false; 3]);
    assert!(x < 1.5 && x > -1.5);
}
